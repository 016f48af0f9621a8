#include "ElementsModel.h"

#include "CornerWay.h"
#include "Document.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "Hiding.h"
#include "Icons.h"
#include "PatchMark.h"
#include "ProblemSet.h"
#include "SeamColors.h"
#include "SeamStretches.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QFont>
#include <QGuiApplication>

#include <algorithm>

namespace bolster {

namespace {

// A kind's index has the internal id 0, an element's its kind's row plus 1.
constexpr quintptr kindLevel = 0;

/// Of what lies on one edge of one patch: which one.
QString edgeText(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    const auto numbered = [&](ElementId patch, double at) {
        const Patch* on = design.find<Patch>(patch);
        const int edge = on && !on->outline.empty() ? edits::edgeNumber(on->outline, at) : 0;
        return edge > 0 ? QCoreApplication::translate("ElementsModel", "edge %1").arg(edge) : QString();
    };
    if (const auto* held = std::get_if<FixationSeam>(element.get()))
        return numbered(held->stretch.patch, held->stretch.from);
    QString text;
    visitMark(*element, [&](const auto& mark) {
        if constexpr (requires { mark.stretch; })
            text = numbered(mark.stretch.patch, mark.stretch.from);
        else if constexpr (requires { mark.place.at; })
            text = numbered(mark.place.patch, mark.place.at);
    });
    return text;
}

/// How long it is, or how far from the corner.
QString measureText(const Design& design, ElementId id)
{
    if (const double length = sewnLength(design, id); length > 0)
        return lengthText(length, 0);
    const Notch* notch = design.find<Notch>(id);
    const Patch* patch = notch ? design.find<Patch>(notch->place.patch) : nullptr;
    const auto way =
        patch && !patch->outline.empty() ? wayFromCorner(patch->outline, notch->place.at) : std::nullopt;
    return way ? QCoreApplication::translate("ElementsModel", "%1 from the corner").arg(lengthText(way->length))
               : QString();
}

} // namespace

ElementsModel::ElementsModel(Document& document, ProblemSet& problems, QObject* parent)
    : QAbstractItemModel(parent)
    , m_document(document)
    , m_problems(problems)
{
    connect(&document, &Document::changed, this, &ElementsModel::update);
    connect(&problems, &ProblemSet::changed, this, &ElementsModel::announceAll);
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, &ElementsModel::update);
    update();
}

/// Several of the same patches: seams by their letters in the pattern, then all by their edges, and by lengths or,
/// of notches, the distance from the corner.
void ElementsModel::tellApart(const Design& design, std::vector<Row>& rows)
{
    std::map<QString, int> count;
    for (const Row& row : rows)
        ++count[row.name];
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Row& row = rows[i];
        if (count[row.name] < 2)
            continue;
        const QString letter = design.find<Seam>(row.id) ? seamLabel(i) : QString();
        for (const QString& words : {letter, edgeText(design, row.id), measureText(design, row.id)})
            if (!words.isEmpty())
                row.name += QStringLiteral(", ") + words;
    }
}

std::vector<ElementsModel::Group> ElementsModel::groupsOf(const Design& design)
{
    std::map<ElementKind, std::vector<Row>> byKind;
    for (const auto& [id, element] : design.elements())
        byKind[kindOf(*element)].push_back(
            {id, listName(design, id), QString::fromStdString(elementNote(*element))});
    for (auto& [kind, rows] : byKind)
        if (!hasName(*design.element(rows.front().id)))
            tellApart(design, rows);
    std::vector<Group> groups;
    // What cannot be used comes first: it wants to be seen.
    for (const bool unusable : {true, false})
        for (auto& [kind, rows] : byKind)
            if ((kind == kindOf<Quarantined>()) == unusable)
                groups.push_back({kind, std::move(rows)});
    return groups;
}

void ElementsModel::update()
{
    std::vector<Group> groups = groupsOf(m_document.design());
    m_seamColors = seamColors(m_document.design(), ViewColors::of(QGuiApplication::palette()).dark);
    const auto sameRows = [](const Group& a, const Group& b) {
        return a.kind == b.kind && std::ranges::equal(a.rows, b.rows, {}, &Row::id, &Row::id);
    };
    if (!std::ranges::equal(groups, m_groups, sameRows)) {
        beginResetModel();
        m_groups = std::move(groups);
        endResetModel();
        return;
    }
    // While something is dragged only names can differ, and mostly none does.
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (groups[g].rows == m_groups[g].rows)
            continue;
        m_groups[g] = std::move(groups[g]);
        const QModelIndex group = index(static_cast<int>(g), 0);
        emit dataChanged(index(0, 0, group), index(rowCount(group) - 1, 0, group));
    }
}

void ElementsModel::recolor()
{
    m_seamColors = seamColors(m_document.design(), ViewColors::of(QGuiApplication::palette()).dark);
    announceAll();
}

void ElementsModel::setHidden(std::set<ElementId> hidden)
{
    m_hidden = std::move(hidden);
    announceAll();
}

void ElementsModel::announceAll()
{
    for (int g = 0; g < rowCount(); ++g) {
        const QModelIndex group = index(g, 0);
        emit dataChanged(index(0, 0, group), index(rowCount(group) - 1, 0, group));
    }
}

QModelIndex ElementsModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kindLevel);
}

QModelIndex ElementsModel::parent(const QModelIndex& index) const
{
    if (!index.isValid() || index.internalId() == kindLevel)
        return {};
    return createIndex(static_cast<int>(index.internalId() - 1), 0, kindLevel);
}

int ElementsModel::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid())
        return static_cast<int>(m_groups.size());
    return parent.internalId() == kindLevel
               ? static_cast<int>(m_groups[static_cast<std::size_t>(parent.row())].rows.size())
               : 0;
}

QVariant ElementsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (index.internalId() == kindLevel)
        return groupData(m_groups[static_cast<std::size_t>(index.row())], role);
    const Group& group = m_groups[static_cast<std::size_t>(index.internalId() - 1)];
    return elementData(group.kind, group.rows[static_cast<std::size_t>(index.row())], role);
}

QVariant ElementsModel::groupData(const Group& group, int role) const
{
    return role == Qt::DisplayRole ? kindTitle(group.kind) : QVariant();
}

QVariant ElementsModel::elementData(ElementKind kind, const Row& row, int role) const
{
    const Design& design = m_document.design();
    switch (role) {
    case Qt::DisplayRole:
        return row.name;
    case Qt::EditRole: {
        const ElementPtr element = design.element(row.id);
        return element ? QString::fromStdString(elementName(*element)) : QString();
    }
    case Qt::FontRole:
        if (!isHidden(design, m_hidden, row.id))
            return {};
        return [] {
            QFont slanted;
            slanted.setItalic(true);
            return slanted;
        }();
    case Qt::ForegroundRole:
        return isHidden(design, m_hidden, row.id) ? ViewColors::of(QGuiApplication::palette()).mutedLabel
                                                  : QVariant();
    case Qt::DecorationRole:
        if (isHidden(design, m_hidden, row.id))
            return icon(QStringLiteral("hide"));
        if (const Fabric* fabric = design.find<Fabric>(row.id))
            return colorSpot(QColor(QString::fromStdString(fabric->color)));
        if (const auto color = m_seamColors.find(row.id); color != m_seamColors.end())
            return colorSpot(color->second);
        return icon(kindIcon(kind));
    case Qt::ToolTipRole: {
        QStringList lines{row.name, m_problems.text(row.id)};
        if (isHidden(design, m_hidden, row.id))
            lines << tr("Hidden in the 3D view");
        lines << row.note;
        lines.removeAll(QString());
        return inShortLines(lines.join(u'\n'));
    }
    case NoteRole:
        return row.note;
    case SearchRole:
        return QString(row.name + u'\n' + kindTitle(kind) + u'\n' + row.note);
    case ElementRole:
        return number(row.id);
    case HiddenRole:
        return isHidden(design, m_hidden, row.id);
    case ProblemRole:
        if (kind == kindOf<Quarantined>() || m_problems.hasError(row.id))
            return 2;
        return m_problems.hasWarning(row.id) ? 1 : 0;
    default:
        return {};
    }
}

bool ElementsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const QString name = value.toString().trimmed();
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable) || name.isEmpty())
        return false;
    const ElementId id{index.data(ElementRole).toInt()};
    m_document.commit(edits::renameElement(m_document.design(), id, name.toStdString()));
    return true;
}

Qt::ItemFlags ElementsModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    if (index.internalId() == kindLevel)
        return Qt::ItemIsEnabled;
    const ElementPtr element = m_document.design().element(ElementId{index.data(ElementRole).toInt()});
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return element && hasName(*element) ? flags | Qt::ItemIsEditable : flags;
}

QModelIndex ElementsModel::indexOf(ElementId id) const
{
    for (std::size_t g = 0; g < m_groups.size(); ++g) {
        const auto& rows = m_groups[g].rows;
        const auto found = std::ranges::find(rows, id, &Row::id);
        if (found != rows.end())
            return createIndex(static_cast<int>(found - rows.begin()), 0, static_cast<quintptr>(g) + 1);
    }
    return {};
}

} // namespace bolster
