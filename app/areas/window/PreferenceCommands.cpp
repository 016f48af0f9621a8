#include "PreferenceCommands.h"

#include "ApplyPreferences.h"
#include "Ask.h"
#include "Commands.h"
#include "CoverLink.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "FabricCommands.h"
#include "FabricPresets.h"
#include "HelpCommands.h"
#include "KeyPresets.h"
#include "PreferencesWindow.h"
#include "SolverLink.h"
#include "Translated.h"

#include <QAction>
#include <QApplication>
#include <QMainWindow>

#include <utility>

namespace bolster {

PreferenceCommands::PreferenceCommands(Commands& commands, PreferenceStore& store, const Parts& parts)
    : m_commands(commands)
    , m_store(store)
    , m_parts(parts)
{
    commands.add({.id = "edit.preferences",
                  .text = tr("Pre&ferences \u2026"),
                  .icon = "settings",
                  .keys = {Qt::CTRL | Qt::Key_Comma},
                  .tip = tr("Units, language, theme, mouse, keys and more"),
                  .places = {"edit/5"},
                  .does = [this] { open(); }});
    connect(&store, &PreferenceStore::changed, this, [this] {
        applyLooks(*qApp, m_store.now());
        apply();
    });
    connect(&store, &PreferenceStore::notKept, this, [this](const Message& why) {
        QWidget* window = m_window ? static_cast<QWidget*>(m_window.data()) : &m_parts.window;
        tell(window, QMessageBox::Warning,
             tr("The preferences could not be stored: they hold only until Bolster is closed."), translated(why));
    });
    apply();
    const std::pair<const char*, const char*> toggles[] = {{"drawing/snapping", "draw.snapping"},
                                                           {"drawing/rulers", "draw.rulers"},
                                                           {"drawing/guides", "draw.guides"}};
    for (const PreferenceRow& setting : preferenceTable())
        for (const auto& [key, id] : toggles)
            if (QLatin1String(key) == QLatin1String(setting.key))
                followToggle(setting, *commands[id]);
}

void PreferenceCommands::followToggle(const PreferenceRow& setting, QAction& toggle)
{
    connect(&toggle, &QAction::toggled, this, [this, &setting](bool on) {
        if (const auto wanted = withValue(m_store.now(), setting, on))
            m_store.set(*wanted);
    });
    connect(&m_store, &PreferenceStore::changed, &toggle,
            [this, &setting, &toggle] { toggle.setChecked(valueOf(m_store.now(), setting).toBool()); });
}

void PreferenceCommands::keysAreLoaded(HelpCommands& help)
{
    connect(&m_store, &PreferenceStore::changed, &help, [this, &help](const Preferences& before) {
        if (m_store.now().keys != before.keys)
            help.setKeyPreset(keyPreset(m_store.now().keys));
    });
}

void PreferenceCommands::apply()
{
    const Preferences& now = m_store.now();
    applyStyles(now);
    const bool reduced = now.drawing == QLatin1String("reduced");
    m_parts.coverView.setReduced(reduced);
    m_parts.covers.setReduced(reduced);
    m_parts.coverView.navigation().setAnimated(!now.reducedMotion);
    m_parts.solver.setGliding(!now.reducedMotion);
    WorkJournal::setDaysInBin(now.daysInBin);
    m_parts.fabrics.setFolder(now.fabricFolder);
    const CutAllowance usual;
    m_parts.session.setStart(
        fabricPreset(now.fabric),
        now.allowance == usual.width ? std::nullopt : std::optional(CutAllowance{now.allowance, usual.corner}));
}

PreferencesWindow& PreferenceCommands::open()
{
    if (!m_window) {
        m_window = new PreferencesWindow(
            m_store,
            PreferencesWindow::Ways{[this] { m_commands["help.edit-shortcuts"]->trigger(); }, m_parts.restart},
            &m_parts.window);
        m_window->setAttribute(Qt::WA_DeleteOnClose);
    }
    m_window->show();
    m_window->raise();
    m_window->activateWindow();
    return *m_window;
}

} // namespace bolster
