// The list of all seams with their lengths and ease.
#pragma once

#include "ElementId.h"

#include <QWidget>

class QSortFilterProxyModel;
class QTreeView;

namespace bolster {

class Document;
class SeamsModel;
class Selection;

/// Its selection is that of the views. Continuity and match are changed in place, for all selected seams if the
/// changed one is among them. Actions added to `table()` are its context menu.
class SeamsView : public QWidget {
    Q_OBJECT

public:
    SeamsView(Document& document, Selection& selection, QWidget* parent = nullptr);

    QTreeView& table() { return *m_table; }

signals:
    /// A double click on a seam.
    void shown(bolster::ElementId id);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildTable();
    void fitColumns();
    void fitNames();
    void selectInTable();
    void selectFromTable();
    void updateHint();

    Document& m_document;
    Selection& m_selection;
    SeamsModel* m_model;
    QSortFilterProxyModel* m_sorted;
    QTreeView* m_table;
    QWidget* m_hint;
    bool m_syncing = false;
};

} // namespace bolster
