// What the window does with scans.
#include "MainWindow.h"

#include "Actions.h"
#include "Ask.h"
#include "FileFlow.h"
#include "Inspector.h"
#include "MapLink.h"
#include "PatternView.h"
#include "ScanEdits.h"
#include "ScanLink.h"
#include "SelectionEdits.h"
#include "StatusLine.h"
#include "Translated.h"

#include <QPointer>
#include <QProgressDialog>

namespace bolster {

void MainWindow::connectScans()
{
    connect(m_scans.get(), &ScanLink::measured, this, &MainWindow::showMeasured);
    connect(m_inspector, &Inspector::framePiecesPointedAt, &m_surface->shown(), &ShownScene::showFramePieces);
    connect(m_inspector, &Inspector::scanWish, this, &MainWindow::workOnScan);
    for (const auto& [action, wish] :
         {std::pair(m_actions->placeScan, ScanWish::FitPlacement), std::pair(m_actions->cutScan, ScanWish::CutAway),
          std::pair(m_actions->keepScan, ScanWish::KeepOnly),
          std::pair(m_actions->keepAroundCover, ScanWish::KeepAroundCover),
          std::pair(m_actions->removeCuts, ScanWish::ShowAll)})
        connect(action, &QAction::triggered, this,
                [this, wish = wish] { onTheScan([this, wish](ElementId scan) { workOnScan(scan, wish); }); });
    connect(m_actions->replaceScan, &QAction::triggered, this,
            [this] { onTheScan([this](ElementId scan) { m_files->replaceFile(scan); }); });
    connect(&document(), &Document::changed, this, &MainWindow::updateScanActions);
    updateScanActions();
}

void MainWindow::updateScanActions()
{
    bool any = false, cut = false;
    document().design().each<Scan>([&](ElementId, const Scan& scan) {
        any = true;
        cut = cut || !scan.cuts.empty();
    });
    for (QAction* action : {m_actions->placeScan, m_actions->cutScan, m_actions->keepScan,
                            m_actions->keepAroundCover, m_actions->replaceScan})
        action->setEnabled(any);
    m_actions->removeCuts->setEnabled(cut);
}

/// The one that is selected, or the only one, which is selected then.
void MainWindow::onTheScan(const std::function<void(ElementId)>& work)
{
    document().cancelGesture();
    const Design& design = document().design();
    std::vector<ElementId> scans = selectedOf<Scan>(design, m_selection.elements());
    if (scans.empty())
        design.each<Scan>([&](ElementId id, const Scan&) { scans.push_back(id); });
    if (scans.size() != 1) {
        m_status->flash(tr("Select the scan that is meant."));
        return;
    }
    m_selection.set({scans.front()});
    work(scans.front());
}

void MainWindow::workOnScan(ElementId scan, ScanWish wish)
{
    document().cancelGesture();
    switch (wish) {
    case ScanWish::FitPlacement:
        fitScanPlacement(scan);
        break;
    case ScanWish::CutAway:
    case ScanWish::KeepOnly:
        m_actions->showScans->setChecked(true); // else there is nothing to be seen of what is cut
        m_surface->startScanCut(scan, wish == ScanWish::KeepOnly);
        break;
    case ScanWish::KeepAroundCover:
        m_scans->keepAroundCover(scan);
        break;
    case ScanWish::ShowAll:
        document().commit(edits::removeCuts(document().design(), scan));
        break;
    }
}

const SurfaceMapPtr& MainWindow::mapShown() const
{
    return m_actions->showDeviation->isChecked() ? m_scans->map() : m_maps->map();
}

void MainWindow::showMeasured()
{
    m_surface->setMap(mapShown());
    m_pattern->setMap(mapShown());
    m_surface->shown().setScanPairs(m_scans->pairs());
    m_inspector->setScanFigures(m_scans->figures());
    readMap(m_mapPlace); // it says something else there now
}

void MainWindow::fitScanPlacement(ElementId scan)
{
    QProgressDialog* progress = openProgress(this, tr("Placing the scan on the cover \u2026")).dialog;
    std::stop_source stop;
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    m_scans->fitPlacement(
        scan, stop,
        [this, progress = QPointer(progress)](int iteration) {
            if (progress)
                progress->setLabelText(tr("Placing the scan on the cover: step %1").arg(iteration));
        },
        [this, progress = QPointer(progress)](const Message& problem) {
            closeProgress(progress);
            if (!problem.empty())
                m_status->flash(translated(problem));
        });
}

} // namespace bolster
