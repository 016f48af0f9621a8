#include "SeamsModel.h"

#include "Document.h"
#include "ElementText.h"
#include "Icons.h"
#include "SeamColors.h"
#include "SeamStretches.h"
#include "SewingOrder.h"
#include "Units.h"
#include "ViewColors.h"

#include <QGuiApplication>
#include <QLocale>

#include <algorithm>

namespace bolster {

SeamsModel::SeamsModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent)
    , m_document(document)
{
    connect(&document, &Document::changed, this, &SeamsModel::update);
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, [this] {
        if (rowCount() > 0)
            emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    });
    update();
}

void SeamsModel::removeGone(const Design& design)
{
    for (int row = rowCount() - 1; row >= 0; --row)
        if (!design.find<Seam>(m_rows[static_cast<std::size_t>(row)].id)) {
            beginRemoveRows({}, row, row);
            m_steps.clear();
            m_rows.erase(m_rows.begin() + row);
            endRemoveRows();
        }
}

void SeamsModel::addNew(const Design& design)
{
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const auto place = std::ranges::lower_bound(m_rows, id, {}, &Row::id);
        if (place != m_rows.end() && place->id == id)
            return;
        const int row = static_cast<int>(place - m_rows.begin());
        beginInsertRows({}, row, row);
        m_steps.clear();
        m_rows.insert(place,
                      {id, design.element(id), design.element(seam.a.patch), design.element(seam.b.patch), {}});
        endInsertRows();
    });
}

void SeamsModel::update()
{
    const Design& design = m_document.design();
    const auto colors = seamColors(design, ViewColors::of(QGuiApplication::palette()).dark);
    const bool recolored = std::exchange(m_colors, colors) != colors; // labels change with them
    const bool stepsAsked = !m_steps.empty();
    removeGone(design);
    addNew(design);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const ElementPtr now = design.element(m_rows[i].id);
        const Seam& seam = std::get<Seam>(*now);
        Row fresh{m_rows[i].id, now, design.element(seam.a.patch), design.element(seam.b.patch), {}};
        if (!recolored && fresh.seam == m_rows[i].seam && fresh.a == m_rows[i].a && fresh.b == m_rows[i].b)
            continue;
        m_rows[i] = std::move(fresh);
        m_steps.clear();
        emit dataChanged(index(static_cast<int>(i), 0), index(static_cast<int>(i), ColumnCount - 1));
    }
    if (stepsAsked && m_steps.empty() && !m_rows.empty()) // one seam more, and others come later
        emit dataChanged(index(0, Step), index(rowCount() - 1, Step));
}

void SeamsModel::recolor()
{
    m_colors.clear();
    update();
}

double SeamsModel::lengthOf(const Stretch& stretch) const
{
    const ElementPtr patch = m_document.design().element(stretch.patch);
    const BSpline2* outline = patch ? planeCurve(*patch) : nullptr;
    if (!outline || outline->empty())
        return 0;
    auto known = m_lengths.find(stretch.patch);
    if (known == m_lengths.end() || known->second.first != patch)
        known = m_lengths.insert_or_assign(stretch.patch, std::pair(patch, ArcLength2(*outline))).first;
    return known->second.second.between(
        stretch.from, unwrappedEnd(stretch.from, stretch.to, outline->domainStart(), outline->domainEnd()));
}

const SeamEase& SeamsModel::easeOf(const Row& row) const
{
    if (!row.ease)
        row.ease = SeamEase{lengthOf(seam(row).a), lengthOf(seam(row).b), seam(row).ease};
    return *row.ease;
}

int SeamsModel::stepOf(const Row& row) const
{
    if (m_steps.empty())
        for (const SewingStep& step : sewingOrder(m_document.design()))
            m_steps.emplace(step.seam, static_cast<int>(m_steps.size()) + 1);
    const auto found = m_steps.find(row.id);
    return found == m_steps.end() ? 0 : found->second;
}

int SeamsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int SeamsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QModelIndex SeamsModel::indexOf(ElementId id) const
{
    const auto place = std::ranges::lower_bound(m_rows, id, {}, &Row::id);
    return place != m_rows.end() && place->id == id ? index(static_cast<int>(place - m_rows.begin()), 0)
                                                    : QModelIndex();
}

QStringList SeamsModel::choices(Column column)
{
    if (column == MatchColumn)
        return {tr("Length"), tr("Parameter")};
    return {QStringLiteral("C0"), QStringLiteral("C1"), QStringLiteral("G1")};
}

/// The patch, and which of its edges when it has several.
QString SeamsModel::sideName(const Stretch& stretch) const
{
    const QString name = displayName(m_document.design(), stretch.patch);
    const Patch* patch = m_document.design().find<Patch>(stretch.patch);
    const int edge = patch ? edits::edgeNumber(patch->outline, stretch.from) : 0;
    return edge > 0 ? QStringLiteral("%1\u00b7%2").arg(name).arg(edge) : name;
}

QVariant SeamsModel::text(const QModelIndex& index) const
{
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (index.column()) {
    case Label:
        return seamLabel(static_cast<std::size_t>(index.row()));
    case Name:
        return QStringLiteral("%1 \u2013 %2").arg(sideName(seam(row).a), sideName(seam(row).b));
    case Difference:
        return easeOf(row).differenceText();
    case Ratio:
        return easeOf(row).ratioText();
    case ContinuityColumn:
        return choices(ContinuityColumn).value(static_cast<int>(seam(row).continuity));
    case LengthA:
        return lengthText(easeOf(row).a);
    case LengthB:
        return lengthText(easeOf(row).b);
    case MatchColumn:
        return choices(MatchColumn).value(static_cast<int>(seam(row).match));
    case Step:
        return QLocale().toString(stepOf(row));
    default:
        return {};
    }
}

/// Ease by its size: the worst ones are looked for, whichever side is longer.
QVariant SeamsModel::sortKey(const QModelIndex& index) const
{
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (index.column()) {
    case Label:
        return index.row();
    case Difference:
        return std::abs(easeOf(row).difference());
    case Ratio:
        return std::abs(easeOf(row).ratio());
    case LengthA:
        return easeOf(row).a;
    case LengthB:
        return easeOf(row).b;
    case Step:
        return stepOf(row);
    default:
        return text(index);
    }
}

QString SeamsModel::toolTip(const Row& row) const
{
    const SeamEase& ease = easeOf(row);
    QStringList lines{displayName(m_document.design(), row.id), seamSummary(m_document.design(), seam(row))};
    if (ease.puckers())
        lines << tr("More than 5 % ease puckers.");
    lines.removeAll(QString());
    return lines.join(u'\n');
}

QVariant SeamsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const bool number = index.column() == Difference || index.column() == Ratio || index.column() == LengthA ||
                        index.column() == LengthB || index.column() == Step;
    switch (role) {
    case Qt::DisplayRole:
        return text(index);
    case SortRole:
        return sortKey(index);
    case ElementRole:
        return bolster::number(row.id);
    case PuckersRole:
        return easeOf(row).puckers();
    case ValueRole:
        return index.column() == MatchColumn ? static_cast<int>(seam(row).match)
                                             : static_cast<int>(seam(row).continuity);
    case Qt::ToolTipRole:
        return inShortLines(toolTip(row));
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignVCenter | (number                               ? Qt::AlignRight
                                            : index.column() == ContinuityColumn ? Qt::AlignHCenter
                                                                                 : Qt::AlignLeft));
    case Qt::DecorationRole:
        if (const auto color = m_colors.find(row.id); index.column() == Label && color != m_colors.end())
            return colorSpot(color->second);
        return {};
    default:
        return {};
    }
}

QVariant SeamsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const QStringList names{QString(),      tr("Seam"),     tr("Ease"),  tr("Ease %"), tr("Joins"),
                            tr("Length 1"), tr("Length 2"), tr("Match"), tr("Step")};
    const QStringList tips{tr("The letter on both stretches in the pattern"),
                           tr("The patches and their edges"),
                           tr("How much longer the second side is than the first one"),
                           tr("The ease over the shorter side; more than 5 % puckers"),
                           tr("C0: an edge, C1: smooth with the texture, G1: rounded"),
                           tr("Of the first side"),
                           tr("Of the second side"),
                           tr("What is sewn together: equal parts of the length, or of the curve's parameter"),
                           tr("The place in the order of sewing; Seam > Sew earlier and Sew later change it")};
    if (role == Qt::DisplayRole)
        return names.value(section);
    return role == Qt::ToolTipRole ? QVariant(tips.value(section)) : QVariant();
}

Qt::ItemFlags SeamsModel::flags(const QModelIndex& index) const
{
    const bool choice = index.column() == ContinuityColumn || index.column() == MatchColumn;
    return QAbstractTableModel::flags(index) | (choice ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

} // namespace bolster
