#include "FirstSteps.h"

#include "Commands.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "FreeCover.h"
#include "LayoutEdits.h"
#include "NextStep.h"
#include "OpenFlow.h"
#include "PatternView.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "StartHint.h"
#include "StartPage.h"

#include <algorithm>
#include <array>
#include <utility>

namespace bolster {

FirstSteps::FirstSteps(Commands& commands, DesignSession& session, Selection& selection, SolverLink& solver,
                       PatternView& pattern, CoverView& coverView, OpenFlow& opening, StartPage& page)
    : m_session(session)
    , m_selection(selection)
    , m_pattern(pattern)
    , m_coverView(coverView)
{
    hintAtStart(commands, opening, page);
    showFreeCover(solver);
    hintAtNext(commands);
    connect(&pattern, &PatternView::toolChanged, this, [this](PatternToolKind kind) {
        constexpr std::array draws{PatternToolKind::Rectangle, PatternToolKind::Ellipse, PatternToolKind::Outline};
        const PatternToolKind before = std::exchange(m_tool, kind);
        if (kind == PatternToolKind::Select && std::ranges::find(draws, before) != draws.end())
            showDrawn();
    });
}

void FirstSteps::hintAtStart(Commands& commands, OpenFlow& opening, StartPage& page)
{
    auto* hint = new StartHint(m_session.document(), m_pattern);
    connect(hint, &StartHint::rectangleWanted, this, [this] { m_pattern.setTool(PatternToolKind::Rectangle); });
    connect(hint, &StartHint::outlineWanted, this, [this] { m_pattern.setTool(PatternToolKind::Outline); });
    connect(hint, &StartHint::frameWanted, commands["file.import-frame"], &QAction::trigger);
    connect(hint, &StartHint::openWanted, this, [&opening] { opening.open(); });
    connect(hint, &StartHint::fileWanted, this, [&opening](const QString& path) { opening.open(path); });
    connect(&page, &StartPage::toggled, hint, &StartHint::setCovered);
    connect(&m_pattern, &PatternView::toolChanged, hint,
            [hint](PatternToolKind kind) { hint->setDrawing(kind != PatternToolKind::Select); });
}

void FirstSteps::showFreeCover(SolverLink& solver)
{
    auto* freeCover = new FreeCover(m_session.document(), solver, m_coverView, this);
    connect(&m_session, &DesignSession::opened, freeCover,
            [this, freeCover] { freeCover->begin(m_coverView.navigation().hasReturned()); });
}

void FirstSteps::hintAtNext(Commands& commands)
{
    auto* next = new NextStep(m_session.document(), m_pattern);
    connect(next, &NextStep::drawWanted, this, [this] { m_pattern.setTool(PatternToolKind::Rectangle); });
    connect(next, &NextStep::sewWanted, this, [this] { m_pattern.setTool(PatternToolKind::Sew); });
    connect(next, &NextStep::fixationWanted, this, [this] { m_coverView.setTool(CoverToolKind::DrawFixation); });
    connect(next, &NextStep::attachWanted, this, [this] { m_pattern.setTool(PatternToolKind::Attach); });
    connect(next, &NextStep::selectAllWanted, commands["edit.select-all"], &QAction::trigger);
}

/// What was drawn with typed lengths can be larger than the view.
void FirstSteps::showDrawn()
{
    const Design& design = m_session.document().design();
    const Box2 seen = m_pattern.navigation().transform().visible(m_pattern.size());
    for (const ElementId id : selectedOf<Patch>(design, m_selection.elements()))
        if (!seen.contains(edits::layoutBox(*design.find<Patch>(id)))) {
            m_pattern.navigation().fitAll();
            return;
        }
}

} // namespace bolster
