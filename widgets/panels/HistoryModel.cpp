#include "HistoryModel.h"

#include "ElementText.h"

#include "Document.h"
#include "Translated.h"

#include <QBuffer>
#include <QImageReader>
#include <QLocale>

#include <set>

namespace bolster {

namespace {

constexpr QSize largestPicture(1024, 1024); // pixels; the file may come from anywhere

} // namespace

HistoryModel::HistoryModel(Document& document, QObject* parent)
    : QAbstractListModel(parent)
    , m_document(document)
{
    connect(&document, &Document::historyReplaced, this, &HistoryModel::rebuild);
    connect(&document, &Document::historyChanged, this, &HistoryModel::follow);
    connect(&document, &Document::named, this, [this](NodeId node) {
        if (const QModelIndex named = indexOf(node); named.isValid())
            emit dataChanged(named, named);
    });
    rebuild();
}

void HistoryModel::rebuild()
{
    beginResetModel();
    m_small.clear();
    m_rows = rowsNow();
    m_current = m_document.history().current();
    m_places.resize(m_rows.size());
    for (std::size_t row = 0; row < m_rows.size(); ++row)
        m_places[static_cast<std::size_t>(m_rows[row].node)] = static_cast<int>(row);
    endResetModel();
}

/// An edit costs one line, a move in the history the lines on the way. A list that only looks different is not made
/// anew: a double click would lose its line between its clicks.
void HistoryModel::follow()
{
    const NodeId count = m_document.history().count();
    const auto known = static_cast<NodeId>(m_rows.size());
    if (count == known || (count == known + 1 && appendLine(known)))
        markDone();
    else
        rebuild();
}

/// False when it begins a branch: then others are indented.
bool HistoryModel::appendLine(NodeId node)
{
    const NodeId parent = m_document.history().node(node).parent;
    if (m_document.history().node(parent).children.size() != 1)
        return false;
    const int above = m_places[static_cast<std::size_t>(parent)];
    beginInsertRows({}, above + 1, above + 1);
    Row row = m_rows[static_cast<std::size_t>(above)];
    row.node = node;
    row.firstOfBranch = row.done = false;
    m_rows.insert(m_rows.begin() + above + 1, row);
    rowOf(parent).lanes |= row.lane();
    m_places.push_back(above + 1);
    for (auto below = m_rows.begin() + above + 2; below != m_rows.end(); ++below)
        ++m_places[static_cast<std::size_t>(below->node)];
    endInsertRows();
    emit dataChanged(index(above), index(above));
    return true;
}

/// Along the way from where the document was to where it is.
void HistoryModel::markDone()
{
    const History& history = m_document.history();
    NodeId from = m_current;
    NodeId to = history.current();
    int first = std::min(m_places[static_cast<std::size_t>(from)], m_places[static_cast<std::size_t>(to)]);
    int last = std::max(m_places[static_cast<std::size_t>(from)], m_places[static_cast<std::size_t>(to)]);
    m_current = to;
    while (from != to) { // a parent has the lower number
        NodeId& leaving = from > to ? from : to;
        rowOf(leaving).done = from < to;
        first = std::min(first, m_places[static_cast<std::size_t>(leaving)]);
        last = std::max(last, m_places[static_cast<std::size_t>(leaving)]);
        leaving = history.node(leaving).parent;
    }
    emit dataChanged(index(first), index(last));
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
        lanes = row->firstOfBranch ? lanes & ~row->lane() : lanes | row->lane();
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
        text(node) + u'\n' +
        QLocale().toString(m_document.history().node(node).time.toLocalTime(), QLocale::ShortFormat);
    const QByteArray png = m_pictures ? m_pictures(node) : QByteArray();
    if (png.isEmpty())
        return when;
    return QStringLiteral("<img src=\"data:image/png;base64,%1\"><br>%2")
        .arg(QString::fromLatin1(png.toBase64()), when.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
}

QString HistoryModel::timeText(NodeId node) const
{
    const QDateTime time = m_document.history().node(node).time.toLocalTime();
    const QLocale locale;
    const QString clock = locale.toString(time.time(), QLocale::ShortFormat);
    return time.date() == QDate::currentDate() ? clock
                                               : locale.toString(time.date(), QLocale::ShortFormat) + u' ' + clock;
}

/// Read when it is seen: a history may be long.
QImage HistoryModel::picture(NodeId node) const
{
    if (const QImage* known = m_small.object(node))
        return *known;
    QByteArray png = m_pictures ? m_pictures(node) : QByteArray();
    QBuffer bytes(&png);
    QImageReader reader(&bytes, "png");
    const bool sensible =
        !png.isEmpty() && reader.size().isValid() && reader.size().boundedTo(largestPicture) == reader.size();
    const QImage image = sensible ? reader.read() : QImage();
    m_small.insert(node, new QImage(image));
    return image;
}

void HistoryModel::setPictures(Pictures pictures)
{
    m_pictures = std::move(pictures);
    m_small.clear();
}

void HistoryModel::pictureMade(NodeId node)
{
    m_small.remove(node);
    if (const QModelIndex changed = indexOf(node); changed.isValid())
        emit dataChanged(changed, changed, {PictureRole});
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
        return inShortLines(toolTip(row.node));
    case Qt::EditRole:
    case NameRole:
        return QString::fromStdString(m_document.history().node(row.node).name);
    case BranchRole:
        return QString::fromStdString(m_document.history().node(row.node).branch);
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
    case TimeRole:
        return timeText(row.node);
    case PictureRole:
        return picture(row.node);
    case LaneBitsRole:
        return row.lanes;
    default:
        return {};
    }
}

bool HistoryModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || (role != Qt::EditRole && role != BranchRole))
        return false;
    const NodeId node = m_rows[static_cast<std::size_t>(index.row())].node;
    const std::string name = value.toString().trimmed().toStdString();
    if (role == BranchRole)
        m_document.nameBranch(node, name);
    else
        m_document.nameVersion(node, name);
    return true;
}

Qt::ItemFlags HistoryModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags plain = QAbstractListModel::flags(index);
    return index.isValid() ? plain | Qt::ItemIsEditable : plain;
}

QModelIndex HistoryModel::indexOf(NodeId node) const
{
    const bool known = node >= 0 && node < static_cast<NodeId>(m_places.size());
    return known ? index(m_places[static_cast<std::size_t>(node)]) : QModelIndex();
}

} // namespace bolster
