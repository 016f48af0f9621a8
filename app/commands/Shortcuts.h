// Which keys call which command: the program's own, those of a preset, and what the user has changed about them.
#pragma once

#include "KeyPresets.h"

#include <QAction>
#include <QHash>
#include <QList>

namespace bolster {

/// Commands are known by their object names; those without one keep their keys. What differs from the program's own
/// keys is kept in the settings.
class Shortcuts {
public:
    /// Takes the present keys of the actions for the program's own and puts those of the preset and of the settings
    /// in their place.
    Shortcuts(const QList<QAction*>& actions, const KeyPreset& preset);
    /// The user's own keys stay, and what they clash with goes without.
    void setPreset(const KeyPreset& preset);

    const QList<QAction*>& actions() const { return m_actions; }
    bool changed(const QAction& action) const;
    /// What else has these keys, or keys that begin with them or with which they begin; null if nothing has.
    QAction* holder(const QKeySequence& keys, const QAction& except) const;
    /// Views and fields need these keys themselves: arrows, Tab, Enter, Escape, Space.
    static bool reserved(const QKeySequence& keys);

    /// One sequence, or none at all. Others that have it keep it: ask holder() first.
    void set(QAction& action, const QKeySequence& keys);
    /// The keys go from whatever has them to this action.
    void takeOver(QAction& action, const QKeySequence& keys);
    void reset(QAction& action);
    void resetAll();

private:
    void apply(QAction& action, const QList<QKeySequence>& keys);

    QList<QAction*> m_actions;
    QHash<const QAction*, QList<QKeySequence>> m_program; ///< without preset
    QHash<const QAction*, QList<QKeySequence>> m_own;     ///< with it
};

} // namespace bolster
