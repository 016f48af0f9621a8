#include "HelpCommands.h"

#include "CommandPalette.h"
#include "Commands.h"
#include "HelpDialogs.h"
#include "Shortcuts.h"
#include "ShortcutsDialog.h"

#include <QMainWindow>
#include <QMenuBar>

namespace bolster {

HelpCommands::HelpCommands(Commands& commands, CommandPalette& palette, QMainWindow& window)
    : m_commands(commands)
    , m_window(window)
{
    commands.add({{.id = "help.find-command",
                   .formerly = "find-a-command",
                   .text = tr("&Find a command \u2026"),
                   .icon = "search",
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_P},
                   .places = {"help/1"},
                   .does = [&palette] { palette.open(); }},
                  {.id = "help.keys",
                   .formerly = "keys-and-mouse",
                   .text = tr("&Keys and mouse \u2026"),
                   .keys = {Qt::SHIFT | Qt::Key_F1},
                   .places = {"help/1"},
                   .does = [this] { showShortcuts(&m_window, m_commands); }},
                  {.id = "help.edit-shortcuts",
                   .formerly = "edit-shortcuts",
                   .text = tr("&Edit shortcuts \u2026"),
                   .places = {"help/1"},
                   .does = [this] { editKeys(); }},
                  {.id = "help.about",
                   .formerly = "about-bolster",
                   .text = tr("&About Bolster"),
                   .places = {"help/2"},
                   .does = [this] { showAbout(&m_window); }}});
}

HelpCommands::~HelpCommands() = default;

void HelpCommands::loadKeys(const KeyPreset& preset)
{
    QList<QAction*> all = m_commands.all(); // of what is not to be seen just now, too
    for (const MenuEntry& entry : commandsOf(*m_window.menuBar()))
        if (!all.contains(entry.action))
            all.append(entry.action);
    m_shortcuts = std::make_unique<Shortcuts>(all, preset);
}

void HelpCommands::setKeyPreset(const KeyPreset& preset)
{
    m_shortcuts->setPreset(preset);
}

void HelpCommands::editKeys()
{
    auto* dialog = new ShortcutsDialog(*m_shortcuts, commandsOf(*m_window.menuBar()), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

} // namespace bolster
