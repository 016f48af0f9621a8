// All commands of the window: an action for each, and the menus and the tool bar that are made of them.
#pragma once

#include "Command.h"

#include <QAction>
#include <QHash>
#include <QObject>

#include <initializer_list>
#include <vector>

class QActionGroup;
class QMainWindow;
class QToolBar;

namespace bolster {

/// Areas add their tables. Actions and menus can be asked for by their ids before they are added; their ids are
/// their object names.
class Commands : public QObject {
public:
    explicit Commands(QMainWindow& window);

    void add(const Command& command);
    void add(std::initializer_list<Command> table);
    void add(const MenuPlace& menu);
    /// An action that somebody else has made becomes a command.
    void adopt(QAction& action, const QByteArray& id, const QByteArray& formerly, const char* place);
    /// When all are added.
    void buildMenus();
    void fill(QToolBar& bar);

    QAction* operator[](const char* id);
    /// Id of the one that was given last: what it asks for belongs to it.
    const QString& last() const { return m_last; }
    QList<QAction*> list(std::initializer_list<const char*> ids);
    /// In the order of the tables.
    QList<QAction*> startingWith(const char* beginning) const;
    QMenu* menu(const char* id);
    /// The actions in the order of the tables.
    QList<QAction*> all() const;

    /// Asks again what is enabled, visible and on: all, or only some whose reasons have changed.
    void update();
    void update(std::initializer_list<const char*> ids);

    /// The action's text without mnemonic and dots; of undo and redo without what it would undo.
    static QString plainText(const QAction& action);
    /// Puts tip or text, and keys, into the tooltip.
    static void describe(QAction& action);
    /// The id under which older settings have it, or empty.
    static QString formerId(const QAction& action);

private:
    struct Entry {
        QByteArray id;
        QAction* action;
        Command command;
    };
    struct Placed {
        QString menu;
        int group;
        QAction* action;
    };

    void place(QAction* action, const char* place);
    void connectAction(QAction* action, const Command& command);
    void group(QAction* action, const Command& command);
    void buildMenu(QMenu& menu);
    static void show(const Entry& entry);

    QMainWindow& m_window;
    QString m_last;
    std::vector<Entry> m_entries;
    std::vector<Placed> m_placed;
    QHash<QByteArray, QAction*> m_actions;
    QHash<QByteArray, QMenu*> m_menus;
    QHash<QByteArray, QActionGroup*> m_groups;
};

} // namespace bolster
