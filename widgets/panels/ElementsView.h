// The list of the design's elements, its selection in step with the views.
#pragma once

#include "ElementId.h"

#include <QSet>
#include <QWidget>

#include <set>

class QPoint;
class QLineEdit;
class QSortFilterProxyModel;
class QTreeView;

namespace bolster {

class Document;
class ElementsModel;
class ProblemSet;
class Selection;

class ElementsView : public QWidget {
    Q_OBJECT

public:
    ElementsView(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent = nullptr);

    QTreeView& tree() { return *m_tree; }
    /// Opens the group, scrolls there and selects.
    void reveal(ElementId id);
    /// For another design.
    void scrollToTop();
    /// What the 3D view hides is marked.
    void setHidden(std::set<bolster::ElementId> hidden);
    /// Starts renaming, if the element has a name.
    void rename(ElementId id);

signals:
    /// A double click on something that cannot be renamed.
    void shown(bolster::ElementId id);
    /// Enter on something selected.
    void propertiesWanted();
    /// By the right button or the menu key, on what is selected then.
    void contextMenuWanted(const QPoint& global);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildTree();
    void selectInTree();
    void selectFromTree();
    void restoreExpanded();
    void askForMenu(const QPoint& at);
    QModelIndex indexOf(ElementId id) const;

    Selection& m_selection;
    ElementsModel* m_model;
    QLineEdit* m_search = nullptr;
    QSortFilterProxyModel* m_filter;
    QTreeView* m_tree;
    QSet<QString> m_collapsed; ///< kinds that the user has closed
    bool m_syncing = false;
};

} // namespace bolster
