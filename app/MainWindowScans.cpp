// What the window does with scans.
#include "MainWindow.h"

#include "Actions.h"
#include "Inspector.h"
#include "MapLink.h"
#include "PatternView.h"
#include "ScanEdits.h"
#include "ScanLink.h"
#include "StatusLine.h"
#include "Translated.h"

#include <QPointer>
#include <QProgressDialog>

namespace bolster {

void MainWindow::connectScans()
{
    connect(m_scans.get(), &ScanLink::measured, this, &MainWindow::showMeasured);
    connect(m_inspector, &Inspector::framePiecePointedAt, m_surface, &SurfaceView::showFramePiece);
    connect(m_inspector, &Inspector::scanWish, this, [this](ElementId scan, ScanWish wish) {
        document().cancelGesture();
        switch (wish) {
        case ScanWish::FitPlacement:
            fitScanPlacement(scan);
            break;
        case ScanWish::CutAway:
        case ScanWish::KeepOnly:
            m_surface->startScanCut(scan, wish == ScanWish::KeepOnly);
            break;
        case ScanWish::KeepAroundCover:
            m_scans->keepAroundCover(scan);
            break;
        case ScanWish::ShowAll:
            document().commit(edits::removeCuts(document().design(), scan));
            break;
        }
    });
}

const SurfaceMapPtr& MainWindow::mapShown() const
{
    return m_actions->showDeviation->isChecked() ? m_scans->map() : m_maps->map();
}

void MainWindow::showMeasured()
{
    m_surface->setMap(mapShown());
    m_pattern->setMap(mapShown());
    m_surface->setScanPairs(m_scans->pairs());
    m_inspector->setScanFigures(m_scans->figures());
}

void MainWindow::fitScanPlacement(ElementId scan)
{
    auto* progress = new QProgressDialog(tr("Placing the scan on the cover \u2026"), tr("Cancel"), 0, 0, this);
    progress->setWindowModality(Qt::WindowModal);
    progress->setMinimumDuration(400);
    progress->setAttribute(Qt::WA_DeleteOnClose);
    progress->setAutoClose(false);
    std::stop_source stop;
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    m_scans->fitPlacement(
        scan, stop,
        [this, progress = QPointer(progress)](int iteration) {
            if (progress)
                progress->setLabelText(tr("Placing the scan on the cover: step %1").arg(iteration));
        },
        [this, progress = QPointer(progress)](const Message& problem) {
            if (progress)
                progress->deleteLater();
            if (!problem.empty())
                m_status->flash(translated(problem));
        });
}

} // namespace bolster
