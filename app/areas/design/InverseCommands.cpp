#include "InverseCommands.h"

#include "Commands.h"
#include "DesignSession.h"
#include "PatternFitWindow.h"

namespace bolster {

InverseCommands::InverseCommands(Commands& commands, DesignSession& session, Selection& selection,
                                 PatternView& pattern, QWidget& window)
    : m_session(session)
    , m_selection(selection)
    , m_pattern(pattern)
    , m_window(window)
{
    const auto anyPatch = [this] {
        bool found = false;
        m_session.document().design().each<Patch>([&](ElementId, const Patch&) { found = true; });
        return found;
    };
    commands.add({.id = "pattern.fit",
                  .text = tr("&Fit to a goal \u2026"),
                  .keys = {Qt::CTRL | Qt::ALT | Qt::Key_G},
                  .tip = tr("Changes the pattern until the cover lies on a scan, or is strained less"),
                  .places = {"pattern/6"},
                  .enabled = anyPatch,
                  .does = [this] { fit(); }});
}

void InverseCommands::fit()
{
    if (!m_fit)
        m_fit = new PatternFitWindow(m_session, m_selection, m_pattern, &m_window);
    m_fit->show();
    m_fit->raise();
    m_fit->activateWindow();
}

} // namespace bolster
