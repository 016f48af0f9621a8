// The seams of the design with their lengths, as a table.
#pragma once

#include "ArcLength.h"
#include "SeamEase.h"

#include <QAbstractTableModel>
#include <QColor>

#include <map>

namespace bolster {

class Document;

/// Rows by increasing id. Lengths are computed when somebody asks for them, and kept until the seam or the outline
/// changes.
class SeamsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Label,
        Name,
        Difference,
        Ratio,
        ContinuityColumn,
        LengthA,
        LengthB,
        MatchColumn,
        Step,
        ColumnCount
    };
    enum Role {
        ElementRole = Qt::UserRole, ///< the id as int
        SortRole,
        PuckersRole, ///< more ease than cloth takes up without folds
        ValueRole,   ///< of continuity and match: the number of the choice
    };

    explicit SeamsModel(Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    QModelIndex indexOf(ElementId id) const;
    /// What a continuity or match can be, in the order of the enumerators.
    static QStringList choices(Column column);
    /// For another theme.
    void recolor();

private:
    /// The elements that the row shows; as long as they are the same objects, so is what it shows.
    struct Row {
        ElementId id{};
        ElementPtr seam, a, b;
        mutable std::optional<SeamEase> ease;
    };

    void update();
    void removeGone(const Design& design);
    void addNew(const Design& design);
    const Seam& seam(const Row& row) const { return std::get<Seam>(*row.seam); }
    const SeamEase& easeOf(const Row& row) const;
    double lengthOf(const Stretch& stretch) const;
    int stepOf(const Row& row) const;
    QString sideName(const Stretch& stretch) const;
    QVariant text(const QModelIndex& index) const;
    QVariant sortKey(const QModelIndex& index) const;
    QString toolTip(const Row& row) const;

    Document& m_document;
    std::vector<Row> m_rows;
    std::map<ElementId, QColor> m_colors;
    mutable std::map<ElementId, std::pair<ElementPtr, ArcLength2>> m_lengths; ///< by patch
    mutable std::map<ElementId, int> m_steps;                                 ///< from 1; empty: to be asked for
};

} // namespace bolster
