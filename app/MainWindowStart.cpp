// What the window does for those who begin a design.
#include "MainWindow.h"

#include "Actions.h"
#include "FileFlow.h"
#include "FreeCover.h"
#include "LayoutEdits.h"
#include "NextStep.h"
#include "PatternView.h"
#include "SelectionEdits.h"
#include "StartHint.h"

namespace bolster {

void MainWindow::connectFirstSteps()
{
    auto* hint = new StartHint(document(), *m_pattern);
    connect(hint, &StartHint::rectangleWanted, this, [this] { m_pattern->setTool(PatternToolKind::Rectangle); });
    connect(hint, &StartHint::outlineWanted, this, [this] { m_pattern->setTool(PatternToolKind::Outline); });
    connect(hint, &StartHint::frameWanted, m_actions->importFrame, &QAction::trigger);
    connect(hint, &StartHint::openWanted, this, [this] { m_files->open(); });
    connect(hint, &StartHint::fileWanted, this, &MainWindow::open);
    connect(m_pattern, &PatternView::toolChanged, hint,
            [hint](PatternToolKind kind) { hint->setDrawing(kind != PatternToolKind::Select); });

    auto* freeCover = new FreeCover(document(), *m_solver, *m_surface, this);
    connect(m_session.get(), &DesignSession::opened, freeCover,
            [this, freeCover] { freeCover->begin(m_surface->navigation().hasReturned()); });
    connect(m_pattern, &PatternView::toolChanged, this, [this](PatternToolKind kind) {
        if (kind == PatternToolKind::Select)
            showDrawn();
    });

    auto* next = new NextStep(document(), *m_pattern);
    connect(next, &NextStep::drawWanted, this, [this] { m_pattern->setTool(PatternToolKind::Rectangle); });
    connect(next, &NextStep::sewWanted, this, [this] { m_pattern->setTool(PatternToolKind::Sew); });
    connect(next, &NextStep::fixationWanted, this, [this] { m_surface->setTool(SurfaceToolKind::DrawFixation); });
    connect(next, &NextStep::attachWanted, this, [this] { m_pattern->setTool(PatternToolKind::Attach); });
    connect(next, &NextStep::selectAllWanted, m_actions->selectAll, &QAction::trigger);
}

/// What was drawn with typed lengths can be larger than the view.
void MainWindow::showDrawn()
{
    const Box2 seen = m_pattern->navigation().transform().visible(m_pattern->size());
    for (const ElementId id : selectedOf<Patch>(document().design(), m_selection.elements()))
        if (!seen.contains(edits::layoutBox(*document().design().find<Patch>(id)))) {
            m_pattern->navigation().fitAll();
            return;
        }
}

} // namespace bolster
