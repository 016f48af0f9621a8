#include "HistoryModel.h"

#include "Document.h"
#include "Translated.h"

#include <QLocale>

#include <algorithm>
#include <set>

namespace bolster {

HistoryModel::HistoryModel(Document& document, QObject* parent)
    : QAbstractListModel(parent)
    , m_document(document)
{
    connect(&document, &Document::historyChanged, this, &HistoryModel::rebuild);
    rebuild();
}

/// A list that only looks different is not made anew: a double click would lose its line between its clicks.
void HistoryModel::rebuild()
{
    std::vector<Row> rows = rowsNow();
    if (std::ranges::equal(rows, m_rows, [](const Row& a, const Row& b) { return a.standsLike(b); })) {
        m_rows = std::move(rows);
        emit dataChanged(index(0), index(rowCount() - 1));
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

std::vector<HistoryModel::Row> HistoryModel::rowsNow() const
{
    const History& history = m_document.history();
    const std::vector<NodeId> path = history.pathTo(history.current());
    const std::set<NodeId> done(path.begin(), path.end());
    std::vector<Row> rows;
    // Depth first with a stack of its own: a history may be much longer than the call stack.
    struct Todo {
        NodeId node;
        int depth;
        bool firstOfBranch;
    };
    std::vector<Todo> todo{{0, 0, false}};
    while (!todo.empty()) {
        const Todo next = todo.back();
        todo.pop_back();
        rows.push_back({next.node, next.depth, next.firstOfBranch, done.contains(next.node), 0});
        const std::vector<NodeId>& children = history.node(next.node).children;
        if (children.empty())
            continue;
        todo.push_back({children.back(), next.depth, false});
        for (auto child = children.rbegin() + 1; child != children.rend(); ++child)
            todo.push_back({*child, next.depth + 1, true});
    }
    // From below: a lane is open where a later row continues it.
    quint32 lanes = 0;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        row->lanes = lanes;
        const quint32 own = 1U << std::min(row->depth, 31);
        lanes = row->firstOfBranch ? lanes & ~own : lanes | own;
    }
    return rows;
}

int HistoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QString HistoryModel::text(NodeId node) const
{
    if (node == 0)
        return tr("Start");
    const Message& verb = m_document.history().node(node).edit.verb;
    return verb.empty() ? tr("Change") : translated(verb);
}

QString HistoryModel::toolTip(NodeId node) const
{
    const QString when =
        QLocale().toString(m_document.history().node(node).time.toLocalTime(), QLocale::ShortFormat);
    const QByteArray png = m_pictures ? m_pictures(node) : QByteArray();
    if (png.isEmpty())
        return when;
    return QStringLiteral("<img src=\"data:image/png;base64,%1\"><br>%2")
        .arg(QString::fromLatin1(png.toBase64()), when.toHtmlEscaped());
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(row.node);
    case Qt::ToolTipRole:
        return toolTip(row.node);
    case Qt::EditRole:
    case NameRole:
        return QString::fromStdString(m_document.history().node(row.node).name);
    case NodeRole:
        return row.node;
    case DepthRole:
        return row.depth;
    case CurrentRole:
        return row.node == m_document.history().current();
    case DoneRole:
        return row.done;
    case FirstOfBranchRole:
        return row.firstOfBranch;
    case LaneBitsRole:
        return row.lanes;
    default:
        return {};
    }
}

bool HistoryModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || role != Qt::EditRole)
        return false;
    const NodeId node = m_rows[static_cast<std::size_t>(index.row())].node;
    m_document.nameVersion(node, value.toString().trimmed().toStdString());
    return true;
}

Qt::ItemFlags HistoryModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags plain = QAbstractListModel::flags(index);
    return index.isValid() ? plain | Qt::ItemIsEditable : plain;
}

QModelIndex HistoryModel::indexOf(NodeId node) const
{
    const auto found = std::ranges::find(m_rows, node, &Row::node);
    return found == m_rows.end() ? QModelIndex() : index(static_cast<int>(found - m_rows.begin()));
}

} // namespace bolster
