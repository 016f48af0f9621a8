// Lets the user choose the keys of every command.
#pragma once

#include "CommandList.h"

#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace bolster {

class Shortcuts;

/// Commands by menu. Keys that are pressed are taken at once; those of another command only on wish.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    /// `commands`: all of the window; those that `shortcuts` does not know are left out.
    ShortcutsDialog(Shortcuts& shortcuts, const QList<MenuEntry>& commands, QWidget* parent);

private:
    void build();
    void fill(const QList<MenuEntry>& commands);
    void filter(const QString& text);
    void showKeys(QTreeWidgetItem* item);
    void showAllKeys();
    void showCurrent();
    void propose(const QKeySequence& keys);
    void note(const QString& text, bool offerTakeOver);
    QAction* current() const;

    Shortcuts& m_shortcuts;
    QLineEdit* m_search;
    QTreeWidget* m_tree;
    QLabel* m_name;
    QKeySequenceEdit* m_keys;
    QPushButton* m_clear;
    QPushButton* m_reset;
    QLabel* m_note;
    QPushButton* m_takeOver;
};

} // namespace bolster
