// The preferences: their window, and what follows from them in the main one.
#pragma once

#include "PreferenceStore.h"

#include <QCoreApplication>
#include <QObject>
#include <QPointer>

#include <functional>

class QAction;
class QMainWindow;

namespace bolster {

class Commands;
class CoverLink;
class CoverView;
class DesignSession;
class FabricCommands;
class HelpCommands;
class PreferencesWindow;
class SolverLink;

class PreferenceCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(PreferenceCommands)

public:
    struct Parts {
        DesignSession& session;
        SolverLink& solver;
        CoverLink& covers;
        CoverView& coverView;
        FabricCommands& fabrics;
        QMainWindow& window;
        std::function<void()> restart; ///< ends the program and starts it again
    };
    /// What the preferences say holds from here on, but for the keys: these are loaded when all menus are there.
    PreferenceCommands(Commands& commands, PreferenceStore& store, const Parts& parts);
    /// They follow from now on.
    void keysAreLoaded(HelpCommands& help);

    PreferencesWindow& open();

private:
    void apply();
    /// Settings that have a toggle in the menus, too.
    void followToggle(const PreferenceRow& setting, QAction& toggle);

    Commands& m_commands;
    PreferenceStore& m_store;
    Parts m_parts;
    QPointer<PreferencesWindow> m_window;
};

} // namespace bolster
