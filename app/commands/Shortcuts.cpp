#include "Shortcuts.h"

#include "Commands.h"

#include <QSettings>

#include <algorithm>

namespace bolster {

namespace {

const QString group = QStringLiteral("shortcuts/");

bool clash(const QKeySequence& a, const QKeySequence& b)
{
    return !a.isEmpty() && !b.isEmpty() &&
           (a.matches(b) != QKeySequence::NoMatch || b.matches(a) != QKeySequence::NoMatch);
}

/// Once: what an older version has kept is kept under the command's own id now.
void carryOver(QSettings& settings, const QAction& action)
{
    const QString former = Commands::formerId(action);
    const QString old = group + former;
    if (former.isEmpty() || !settings.contains(old))
        return;
    if (const QString now = group + action.objectName(); !settings.contains(now))
        settings.setValue(now, settings.value(old));
    settings.remove(old);
}

} // namespace

Shortcuts::Shortcuts(const QList<QAction*>& actions, const KeyPreset& preset)
{
    QSettings settings;
    for (QAction* action : actions) {
        if (action->objectName().isEmpty())
            continue;
        carryOver(settings, *action);
        m_actions.append(action);
        m_program.insert(action, action->shortcuts());
    }
    setPreset(preset);
}

void Shortcuts::setPreset(const KeyPreset& preset)
{
    m_own = m_program;
    for (const auto& [id, keys] : preset.keys)
        for (QAction* action : m_actions)
            if (action->objectName() == QLatin1String(id))
                m_own[action] = keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys};
    const QSettings settings;
    QList<QKeySequence> chosen;
    const auto stored = [&](const QAction* action) { return settings.contains(group + action->objectName()); };
    for (QAction* action : m_actions)
        if (stored(action)) {
            apply(*action, QKeySequence::listFromString(settings.value(group + action->objectName()).toString(),
                                                        QKeySequence::PortableText));
            chosen += action->shortcuts();
        }
    const auto taken = [&](const QKeySequence& own) {
        return std::ranges::any_of(chosen, [&](const QKeySequence& keys) { return clash(own, keys); });
    };
    for (QAction* action : m_actions)
        if (!stored(action)) {
            QList<QKeySequence> keys = m_own.value(action);
            keys.removeIf(taken);
            if (keys != action->shortcuts())
                apply(*action, keys);
        }
}

bool Shortcuts::changed(const QAction& action) const
{
    return action.shortcuts() != m_own.value(&action);
}

QAction* Shortcuts::holder(const QKeySequence& keys, const QAction& except) const
{
    const auto has = [&](const QAction* action) {
        return action != &except &&
               std::ranges::any_of(action->shortcuts(), [&](const QKeySequence& own) { return clash(own, keys); });
    };
    const auto found = std::ranges::find_if(m_actions, has);
    return found == m_actions.end() ? nullptr : *found;
}

bool Shortcuts::reserved(const QKeySequence& keys)
{
    if (keys.isEmpty())
        return false;
    const QKeyCombination first = keys[0];
    switch (first.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Escape:
    case Qt::Key_Space:
        return (first.keyboardModifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    default:
        return false;
    }
}

void Shortcuts::apply(QAction& action, const QList<QKeySequence>& keys)
{
    action.setShortcuts(keys);
    Commands::describe(action);
}

void Shortcuts::set(QAction& action, const QKeySequence& keys)
{
    apply(action, keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys});
    QSettings settings;
    if (changed(action))
        settings.setValue(group + action.objectName(),
                          QKeySequence::listToString(action.shortcuts(), QKeySequence::PortableText));
    else
        settings.remove(group + action.objectName());
}

void Shortcuts::takeOver(QAction& action, const QKeySequence& keys)
{
    while (QAction* loser = holder(keys, action)) {
        QList<QKeySequence> left = loser->shortcuts();
        left.removeIf([&](const QKeySequence& own) { return clash(own, keys); });
        apply(*loser, left);
        QSettings().setValue(group + loser->objectName(),
                             QKeySequence::listToString(left, QKeySequence::PortableText));
    }
    set(action, keys);
}

void Shortcuts::reset(QAction& action)
{
    apply(action, m_own.value(&action));
    QSettings().remove(group + action.objectName());
}

void Shortcuts::resetAll()
{
    for (QAction* action : m_actions)
        reset(*action);
}

} // namespace bolster
