// The elements of the design by kind.
#pragma once

#include "ElementText.h"

#include <QAbstractItemModel>
#include <QColor>

#include <set>

namespace bolster {

class Document;
class ProblemSet;

/// Two levels: kinds that have elements, and these by id.
class ElementsModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Role {
        ElementRole = Qt::UserRole, ///< the id as int; nothing for kinds
        ProblemRole,                ///< 0 none, 1 warning, 2 error
        HiddenRole,                 ///< whether the 3D view hides it
        NoteRole,                   ///< what people have written at it
        SearchRole,                 ///< by what it is found: name and note
    };

    ElementsModel(Document& document, ProblemSet& problems, QObject* parent = nullptr);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return 1; }
    QVariant data(const QModelIndex& index, int role) const override;
    /// Renames.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    /// What the 3D view hides.
    void setHidden(std::set<ElementId> hidden);

    QModelIndex indexOf(ElementId id) const;
    /// For another theme.
    void recolor();

private:
    struct Row {
        ElementId id{};
        QString name;
        QString note = {};
        friend bool operator==(const Row&, const Row&) = default;
    };
    struct Group {
        ElementKind kind;
        std::vector<Row> rows;
    };

    static void tellApart(const Design& design, std::vector<Row>& rows);
    static std::vector<Group> groupsOf(const Design& design);
    void update();
    void announceAll();
    QVariant groupData(const Group& group, int role) const;
    QVariant elementData(ElementKind kind, const Row& row, int role) const;

    Document& m_document;
    ProblemSet& m_problems;
    std::vector<Group> m_groups;
    std::map<ElementId, QColor> m_seamColors;
    std::set<ElementId> m_hidden; ///< in the 3D view
};

} // namespace bolster
