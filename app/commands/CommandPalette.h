// A field to type into that finds every command of the window.
#pragma once

#include "CommandList.h"

#include <QFrame>
#include <QPointer>

class QLineEdit;
class QListWidget;
class QMainWindow;

namespace bolster {

/// Lies over the window; up and down choose, Enter does, Escape or a click elsewhere closes. What was done last
/// comes first. Disabled commands are shown grey and do nothing.
class CommandPalette : public QFrame {
    Q_OBJECT

public:
    explicit CommandPalette(QMainWindow& window);

    void open();
    QLineEdit& field() { return *m_field; }
    QListWidget& list() { return *m_list; }
    /// The command of a row.
    const MenuEntry& commandAt(int row) const { return m_shown[row]; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void close(bool giveFocusBack);
    void place();
    void filter();
    void run(int row);
    bool handleKey(int key);

    QMainWindow& m_window;
    QLineEdit* m_field;
    QListWidget* m_list;
    QList<MenuEntry> m_commands; ///< recently used ones first
    QList<MenuEntry> m_shown;
    QPointer<QWidget> m_focusBefore;
};

} // namespace bolster
