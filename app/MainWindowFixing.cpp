// What the window does with fixation curves.
#include "MainWindow.h"

#include "Actions.h"
#include "FixationEdits.h"
#include "PatternView.h"
#include "StatusLine.h"
#include "StretchToFix.h"
#include "Translated.h"

namespace bolster {

void MainWindow::connectFixing()
{
    connect(m_actions->createFixation, &QAction::triggered, this, &MainWindow::createFixation);
    connect(&m_selection, &Selection::changed, this, &MainWindow::updateFixingActions);
    connect(&document(), &Document::historyChanged, this, &MainWindow::updateFixingActions);
    updateFixingActions();
}

void MainWindow::updateFixingActions()
{
    m_actions->createFixation->setEnabled(stretchToFix(document().design(), m_selection).has_value());
}

void MainWindow::createFixation()
{
    document().cancelGesture();
    const Design& design = document().design();
    const std::optional<Stretch> stretch = stretchToFix(design, m_selection);
    if (!stretch) {
        m_status->flash(tr("Select two points of an outline first: what lies between them is fixed."));
        return;
    }
    if (const auto problem = edits::fixationProblem(design, *stretch)) {
        m_status->flash(translated(*problem));
        return;
    }
    int count = 1;
    design.each<FixationCurve>([&](ElementId, const FixationCurve&) { ++count; });
    const SurfaceMeshPtr surface = m_solver->surface();
    insert(surface ? edits::addFixationFromSurface(design, *surface, *stretch,
                                                   tr("Fixation %1").arg(count).toStdString())
                   : Edit{},
           tr("There is no surface of this patch yet on which the curve could lie."));
}

} // namespace bolster
