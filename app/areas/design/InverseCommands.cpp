#include "InverseCommands.h"

#include "Commands.h"
#include "DesignSession.h"
#include "FormPatternWindow.h"
#include "PatternFitWindow.h"
#include "PatternView.h"
#include "Selection.h"

namespace bolster {

InverseCommands::InverseCommands(Commands& commands, DesignSession& session, Selection& selection,
                                 SolverLink& solver, PatternView& pattern, QWidget& window)
    : m_session(session)
    , m_selection(selection)
    , m_solver(solver)
    , m_pattern(pattern)
    , m_window(window)
{
    const auto anyPatch = [this] {
        bool found = false;
        m_session.document().design().each<Patch>([&](ElementId, const Patch&) { found = true; });
        return found;
    };
    commands.add(
        {.id = "pattern.from-form",
         .text = tr("From a form \u2026"),
         .keys = {Qt::CTRL | Qt::ALT | Qt::Key_O},
         .tip = tr("Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of "
                   "them"),
         .places = {"pattern/6"},
         .does = [this] { fromForm(); }});
    commands.add({.id = "pattern.fit",
                  .text = tr("F&it to a goal \u2026"),
                  .keys = {Qt::CTRL | Qt::ALT | Qt::Key_G},
                  .tip = tr("Changes the pattern until the cover lies on a scan, or is strained less"),
                  .places = {"pattern/6"},
                  .enabled = anyPatch,
                  .does = [this] { fit(); }});
}

/// They go before what they use: as children of the window they would go after it.
InverseCommands::~InverseCommands()
{
    delete m_fit;
    delete m_form;
}

void InverseCommands::fit()
{
    if (!m_fit)
        m_fit = new PatternFitWindow(m_session, m_selection, m_pattern, &m_window);
    m_fit->show();
    m_fit->raise();
    m_fit->activateWindow();
}

void InverseCommands::fromForm()
{
    if (!m_form) {
        auto* window = new FormPatternWindow(m_session, m_solver, &m_window);
        connect(window, &FormPatternWindow::patternMade, this, [this](const std::vector<ElementId>& added) {
            m_selection.set({added.begin(), added.end()});
            m_pattern.navigation().fitAll();
        });
        m_form = window;
    }
    m_form->show();
    m_form->raise();
    m_form->activateWindow();
}

} // namespace bolster
