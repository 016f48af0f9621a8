// The Help menu: commands, keys, and about the program.
#pragma once

#include <QCoreApplication>
#include <QObject>

#include <memory>

class QMainWindow;

namespace bolster {

class CommandPalette;
class Commands;
class Shortcuts;
struct KeyPreset;

class HelpCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(HelpCommands)

public:
    HelpCommands(Commands& commands, CommandPalette& palette, QMainWindow& window);
    ~HelpCommands() override;

    /// Puts the user's keys in the place of the program's; when all menus are there.
    void loadKeys(const KeyPreset& preset);
    void setKeyPreset(const KeyPreset& preset);

private:
    void editKeys();

    Commands& m_commands;
    QMainWindow& m_window;
    std::unique_ptr<Shortcuts> m_shortcuts;
};

} // namespace bolster
