#include "Commands.h"

#include "Icons.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include <algorithm>
#include <map>

namespace bolster {

namespace {

constexpr char tipProperty[] = "tip";
constexpr char formerProperty[] = "formerId";
constexpr int barGroup = 100;

} // namespace

Commands::Commands(QMainWindow& window)
    : QObject(&window)
    , m_window(window)
{}

QAction* Commands::operator[](const char* id)
{
    QAction*& action = m_actions[id];
    if (!action) {
        action = new QAction(this);
        action->setObjectName(QString::fromLatin1(id));
        action->setMenuRole(QAction::NoRole);
    }
    return action;
}

QMenu* Commands::menu(const char* id)
{
    QMenu*& menu = m_menus[id];
    if (!menu) {
        menu = new QMenu(m_window.menuBar());
        menu->setObjectName(QString::fromLatin1(id));
    }
    return menu;
}

void Commands::add(std::initializer_list<Command> table)
{
    for (const Command& command : table)
        add(command);
}

void Commands::add(const Command& command)
{
    QAction* action = (*this)[command.id];
    action->setProperty(formerProperty, QString::fromLatin1(command.formerly));
    action->setProperty(tipProperty, command.tip);
    action->setText(command.text);
    if (command.textNow)
        action->setIconText(plainText(*action));
    if (*command.icon)
        action->setIcon(icon(QString::fromLatin1(command.icon)));
    action->setShortcuts(command.keys);
    describe(*action);
    group(action, command);
    action->setCheckable(command.on || command.checked);
    action->setChecked(command.on.value_or(false));
    connectAction(action, command);
    for (const char* at : command.places)
        place(action, at);
    m_entries.push_back({command.id, action, command});
}

void Commands::group(QAction* action, const Command& command)
{
    if (!*command.group)
        return;
    QActionGroup*& group = m_groups[command.group];
    if (!group) {
        group = new QActionGroup(this);
        group->setExclusionPolicy(command.orNone ? QActionGroup::ExclusionPolicy::ExclusiveOptional
                                                 : QActionGroup::ExclusionPolicy::Exclusive);
    }
    group->addAction(action);
}

void Commands::connectAction(QAction* action, const Command& command)
{
    if (command.toggled)
        connect(action, &QAction::toggled, this, command.toggled);
    if (!command.does)
        return;
    connect(action, &QAction::triggered, this, [this, does = command.does, id = command.id] {
        m_last = QString::fromLatin1(id);
        does();
        for (const Entry& entry : m_entries) // the action has changed its mark, whatever has come of it
            if (entry.command.checked)
                entry.action->setChecked(entry.command.checked());
    });
}

void Commands::add(const MenuPlace& added)
{
    QMenu* made = menu(added.id);
    made->setTitle(added.title);
    if (added.fill)
        connect(made, &QMenu::aboutToShow, this, [made, fill = added.fill] { fill(*made); });
    place(made->menuAction(), added.place);
}

void Commands::adopt(QAction& action, const QByteArray& id, const QByteArray& formerly, const char* at)
{
    action.setObjectName(QString::fromLatin1(id));
    action.setProperty(formerProperty, QString::fromLatin1(formerly));
    m_actions.insert(id, &action);
    m_entries.push_back({id, &action, {}});
    place(&action, at);
}

void Commands::place(QAction* action, const char* at)
{
    const QString text = QString::fromLatin1(at);
    m_placed.push_back({text.section(u'/', 0, 0), text.section(u'/', 1).toInt(), action});
}

void Commands::buildMenus()
{
    std::ranges::stable_sort(m_placed, {}, &Placed::group);
    for (const Placed& placed : m_placed)
        if (placed.menu.isEmpty())
            m_window.menuBar()->addAction(placed.action);
    for (QMenu* menu : std::as_const(m_menus))
        buildMenu(*menu);
}

void Commands::buildMenu(QMenu& menu)
{
    std::optional<int> last;
    for (const auto& [name, group, action] : m_placed) {
        if (name != menu.objectName())
            continue;
        if (last && *last != group)
            menu.addSeparator();
        last = group;
        menu.addAction(action);
    }
}

void Commands::fill(QToolBar& bar)
{
    std::map<int, QAction*> order;
    for (const Entry& entry : m_entries)
        if (entry.command.bar > 0)
            order.emplace(entry.command.bar, entry.action);
    int last = order.empty() ? 0 : order.begin()->first;
    for (const auto& [at, action] : order) {
        if (at / barGroup != last / barGroup)
            bar.addSeparator();
        last = at;
        bar.addAction(action);
    }
}

QList<QAction*> Commands::list(std::initializer_list<const char*> ids)
{
    QList<QAction*> found;
    for (const char* id : ids)
        found.append((*this)[id]);
    return found;
}

QList<QAction*> Commands::startingWith(const char* beginning) const
{
    QList<QAction*> found;
    for (const Entry& entry : m_entries)
        if (entry.id.startsWith(beginning))
            found.append(entry.action);
    return found;
}

QList<QAction*> Commands::all() const
{
    return startingWith("");
}

void Commands::show(const Entry& entry)
{
    const auto& [id, action, command] = entry;
    if (command.enabled)
        action->setEnabled(command.enabled());
    if (command.visible)
        action->setVisible(command.visible());
    if (command.checked)
        action->setChecked(command.checked());
    if (command.textNow)
        action->setText(command.textNow());
}

void Commands::update()
{
    for (const Entry& entry : m_entries)
        show(entry);
}

void Commands::update(std::initializer_list<const char*> ids)
{
    for (const Entry& entry : m_entries)
        if (std::ranges::any_of(ids, [&](const char* id) { return entry.id == id; }))
            show(entry);
}

QString Commands::plainText(const QAction& action)
{
    QString text = action.iconText();
    return text.remove(u'&').remove(QStringLiteral("\u2026")).trimmed();
}

void Commands::describe(QAction& action)
{
    const QString tip = action.property(tipProperty).toString();
    const QString text = tip.isEmpty() ? plainText(action) : tip;
    const QKeySequence key = action.shortcut();
    action.setToolTip(key.isEmpty() ? text
                                    : QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
}

QString Commands::formerId(const QAction& action)
{
    return action.property(formerProperty).toString();
}

} // namespace bolster
