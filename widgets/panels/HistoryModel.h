// The tree of edits as lines for a list.
#pragma once

#include "History.h"

#include <QAbstractListModel>
#include <QCache>
#include <QImage>

#include <algorithm>
#include <functional>

namespace bolster {

class Document;

/// The newest branch runs straight down; an older one stands indented right below the edit where it began. The
/// order never changes when the user moves in the history, so nothing jumps under the pointer.
class HistoryModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        NodeRole = Qt::UserRole, ///< NodeId
        DepthRole,               ///< 0: the newest branch, 1: beside it ...
        CurrentRole,             ///< bool
        DoneRole,                ///< bool: on the way from the start to the current edit
        FirstOfBranchRole,       ///< bool: the line comes from a less indented one
        LaneBitsRole,            ///< quint32: at which depths a line passes on downwards
        NameRole,                ///< QString: what the user calls this version, or ""
        BranchRole,              ///< QString: what the user calls the branch that begins here, or ""
        TimeRole,                ///< QString: when it was made, as short as today allows
        PictureRole,             ///< QImage: small, null where there is none
    };

    explicit HistoryModel(Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// Qt::EditRole names a version, BranchRole the branch that begins there.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QModelIndex indexOf(NodeId node) const;
    /// PNGs of versions; empty ones where there are none.
    using Pictures = std::function<QByteArray(NodeId)>;
    void setPictures(Pictures pictures);
    /// It has another one now.
    void pictureMade(NodeId node);

private:
    struct Row {
        NodeId node = 0;
        int depth = 0;
        bool firstOfBranch = false;
        bool done = false;
        quint32 lanes = 0;

        quint32 lane() const { return 1U << std::min(depth, 31); }
    };

    void rebuild();
    void follow();
    bool appendLine(NodeId node);
    void markDone();
    std::vector<Row> rowsNow() const;
    Row& rowOf(NodeId node) { return m_rows[static_cast<std::size_t>(m_places[static_cast<std::size_t>(node)])]; }
    QString text(NodeId node) const;
    QString toolTip(NodeId node) const;
    QString timeText(NodeId node) const;
    QImage picture(NodeId node) const;

    Document& m_document;
    Pictures m_pictures;
    mutable QCache<NodeId, QImage> m_small{300}; // pictures that were seen lately; null ones, too
    std::vector<Row> m_rows;
    std::vector<int> m_places; // rows by node
    NodeId m_current = 0;      // up to there rows are marked as done
};

} // namespace bolster
