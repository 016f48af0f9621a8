// What the window does with patches: clipboard, layout, shapes.
#include "MainWindow.h"

#include "PatternCommands.h"
#include "StatusLine.h"

namespace bolster {

void MainWindow::connectPattern()
{
    auto* commands = new PatternCommands(document(), m_selection, *m_actions, this);
    connect(commands, &PatternCommands::said, m_status, &StatusLine::flash);
}

} // namespace bolster
