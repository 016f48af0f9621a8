// Two versions of a design side by side, with what differs.
#pragma once

#include "DesignFiles.h"
#include "Document.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QPushButton;
class QTreeWidget;

namespace bolster {

class FabricLink;
class SolverLink;
class VersionPane;

/// The other version is on the left, the present one on the right; what is chosen in the list can be taken over.
/// Deletes itself when it is closed: what it shows is large.
class CompareWindow : public QWidget {
    Q_OBJECT

public:
    using FilesOf = std::function<DesignFiles(const Design& design)>; ///< as far as they have been read
    /// `solver` is that of the document: neither the present version is computed twice, nor another one that it
    /// still has the surface of.
    CompareWindow(Document& document, FilesOf filesOf, FabricLink& fabrics, SolverLink& solver,
                  QWidget* parent = nullptr);

    /// The version at a node; false when it cannot be read any more.
    bool compareWith(NodeId node);
    /// Some more have been read.
    void updateFiles();
    QTreeWidget& differences() { return *m_list; }
    QPushButton& take() { return *m_take; }
    QCheckBox& together() { return *m_together; }
    VersionPane& left() { return *m_left; }
    VersionPane& right() { return *m_right; }

private:
    void layOut();
    void tieViews(VersionPane& moved, VersionPane& other);
    void showOther(Design apart);
    void refresh();
    void bakeFabrics();
    void fillList();
    void chooseWhole();
    void selectionChanged();
    void takeChosen();
    QString titleOf(NodeId node) const;
    std::set<ElementId> chosen() const;

    Document& m_document;
    FilesOf m_filesOf;
    FabricLink& m_fabrics;
    QString m_title;   ///< of the other version
    Design m_original; ///< as it was
    Design m_other;    ///< the same, in which a number is that of one thing (numberedApart)
    VersionPane* m_left;
    VersionPane* m_right;
    QTreeWidget* m_list;
    QPushButton* m_take;
    QCheckBox* m_together;
    bool m_following = false; ///< a view is being moved because the other one was
};

} // namespace bolster
