// What the window does with maps and pictures.
#include "MainWindow.h"

#include "Actions.h"
#include "Ask.h"
#include "Docks.h"
#include "FabricLink.h"
#include "FileFlow.h"
#include "FindingsLink.h"
#include "MapLink.h"
#include "PatternView.h"
#include "RenderDialog.h"
#include "SpotsPanel.h"
#include "StatusLine.h"
#include "Translated.h"

#include <QMenu>
#include <QMenuBar>

namespace bolster {

void MainWindow::connectMaps()
{
    connect(m_maps.get(), &MapLink::measured, this, &MainWindow::showMeasured);
    for (QAction* action : m_actions->maps)
        connect(action, &QAction::toggled, this, [this] {
            std::optional<CoverMap::Kind> kind;
            for (const QAction* map : m_actions->maps)
                if (map->isChecked())
                    kind = static_cast<CoverMap::Kind>(map->data().toInt());
            m_maps->setKind(kind);
            showMeasured();
        });
    const auto forgetPlace = [this] { // it was one of another map
        m_surface->showPlace({});
        m_pattern->showPlace({});
        readMap({});
    };
    for (QAction* action : m_actions->maps)
        connect(action, &QAction::toggled, this, forgetPlace);
    connect(m_actions->showDeviation, &QAction::toggled, this, forgetPlace);
    connect(m_docks->spots, &QDockWidget::visibilityChanged, this, [forgetPlace](bool visible) {
        if (!visible)
            forgetPlace();
    });
    connect(m_surface, &SurfaceView::coverPointed, this, &MainWindow::readMap);
    connect(m_pattern, &PatternView::patchPointed, this, &MainWindow::readMap);
    connect(m_docks->cover, &QDockWidget::visibilityChanged, m_pattern,
            [this](bool visible) { m_pattern->setLegendShown(!visible); });
    if (auto* spots = menuBar()->findChild<QMenu*>(QStringLiteral("worst-spots")))
        connect(spots, &QMenu::aboutToShow, this, [this, spots] { fillWorstSpots(*spots); });
    connect(m_spots, &SpotsPanel::chosen, this, &MainWindow::showSpot);
    connect(m_actions->showSpotList, &QAction::triggered, this, [this] {
        const bool hidden = m_docks->spots->isHidden();
        Docks::reveal(m_docks->spots);
        if (hidden) // else it is as large as somebody made it
            resizeDocks({m_docks->spots}, {m_docks->spots->sizeHint().height()}, Qt::Vertical);
        m_spots->setFocus();
    });
}

void MainWindow::readMap(const std::optional<CoverPoint>& place)
{
    m_mapPlace = place;
    const SurfaceMapPtr& map = mapShown();
    const QString reading = place && map ? MapLink::reading(*map, *place) : QString();
    m_surface->setMapReading(reading);
    m_pattern->setMapReading(reading);
}

void MainWindow::fillWorstSpots(QMenu& menu)
{
    menu.clear();
    for (const MapLink::Spot& spot : m_maps->spots()) {
        QAction* action = menu.addAction(QString(spot.text).replace(u'&', QStringLiteral("&&")));
        action->setToolTip(tr("Show this place in both windows"));
        connect(action, &QAction::triggered, this, [this, place = spot.place] { showSpot(place); });
    }
    if (menu.isEmpty())
        menu.addAction(tr("Choose a map of strain first"))->setEnabled(false);
}

void MainWindow::showSpot(const CoverPoint& place)
{
    m_surface->reveal(place);
    m_pattern->reveal(place);
    m_surface->showPlace(place);
    m_pattern->showPlace(place);
}

void MainWindow::connectFindings()
{
    // What is not on the screen yet is not called good.
    const auto update = [this] {
        const bool seen = m_surface->pictures(m_solver->surface());
        m_status->setFindings(m_findings->findings(), seen && m_findings->known());
    };
    connect(m_findings.get(), &FindingsLink::changed, this, update);
    // A window that is destroyed hides its docks, when the findings are gone.
    connect(m_surface, &SurfaceView::pictured, m_findings.get(), update);
    connect(m_docks->cover, &QDockWidget::visibilityChanged, m_findings.get(), update);
    connect(m_status, &StatusLine::culpritWanted, this, &MainWindow::showProblem);
    connect(m_status, &StatusLine::findingWanted, this, [this](const CoverFinding& finding) {
        if (!document().design().element(finding.element))
            return;
        m_selection.set({finding.element});
        if (finding.place)
            showSpot({finding.place->patch, finding.place->outline});
        else
            fitSelection();
    });
}

/// Whatever leaves the window shows the surface that follows from the design, never what a drag has left.
void MainWindow::withCoverAtRest(const std::function<void()>& then)
{
    document().cancelGesture();
    if (!m_solver->atRest())
        m_status->flash(tr("As soon as the cover has come to rest \u2026"));
    m_solver->whenAtRest(this, [this, then](const SurfaceMeshPtr& surface) {
        if (surface)
            then();
        else if (m_solver->paused())
            m_status->flash(tr("This needs the cover of the present design: let the solver go on first (Pause)."));
        else if (m_solver->status().state == SolverStatus::State::Failed)
            m_status->flash(translated(m_solver->status().reason));
    });
}

void MainWindow::renderPicture()
{
    const SurfaceMeshPtr& surface = m_solver->surface();
    if (!surface)
        return;
    RenderDialog::Subject subject{surface,
                                  document().design(),
                                  m_session->files(),
                                  m_fabricLink->baker(),
                                  m_fabricLink->bakedByNow(),
                                  m_session->title(),
                                  m_surface->navigation().camera(),
                                  m_files->proposedPicture()};
    openDialog(new RenderDialog(std::move(subject), this));
}

} // namespace bolster
