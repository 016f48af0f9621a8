#include "SeamLineList.h"

#include <QSignalBlocker>

#include <set>

namespace bolster {

namespace {

/// Drawn to be seam lines, and not to hold a cover, or one that was made here.
std::set<ElementId> linesToCut(const Design& design)
{
    std::set<ElementId> lines;
    design.each<FixationCurve>([&](ElementId id, const FixationCurve&) { lines.insert(id); });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) { lines.erase(seam.curve); });
    return lines;
}

/// Names of curves, with numbers where several have one.
std::map<ElementId, QString> lineNames(const Design& design)
{
    std::map<std::string, int> count, used;
    design.each<FixationCurve>([&](ElementId, const FixationCurve& curve) { ++count[curve.name]; });
    std::map<ElementId, QString> names;
    design.each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        const QString name = QString::fromStdString(curve.name);
        names[id] = count[curve.name] > 1 ? QStringLiteral("%1 (%2)").arg(name).arg(++used[curve.name]) : name;
    });
    return names;
}

ElementId curveOf(const QTreeWidgetItem& item)
{
    return static_cast<ElementId>(item.data(0, Qt::UserRole).toUInt());
}

} // namespace

SeamLineList::SeamLineList(QWidget* parent)
    : QTreeWidget(parent)
{
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setAccessibleName(tr("Seam lines"));
    setToolTip(tr("Fixation curves of the design. Draw seam lines on a frame with the tool for fixation "
                  "curves: what is drawn meanwhile is cut at once"));
    connect(this, &QTreeWidget::itemChanged, this, &SeamLineList::ticksChanged);
}

void SeamLineList::fill(const Design& design)
{
    const std::set<ElementId> usual = linesToCut(design);
    const States before = states();
    const bool wasOpen = topLevelItemCount() > 0 && topLevelItem(topLevelItemCount() - 1)->isExpanded();
    const QSignalBlocker quiet(this);
    clear();
    auto* holding = new QTreeWidgetItem;
    for (const auto& [id, name] : lineNames(design)) {
        auto* row = new QTreeWidgetItem(QStringList{name});
        row->setData(0, Qt::UserRole, number(id));
        const auto known = before.find(static_cast<quint32>(number(id)));
        const Qt::CheckState fresh = usual.contains(id) ? Qt::Checked : Qt::Unchecked;
        row->setCheckState(0, known == before.end() ? fresh : known->second);
        if (usual.contains(id))
            addTopLevelItem(row);
        else
            holding->addChild(row);
    }
    setRootIsDecorated(holding->childCount() > 0);
    if (holding->childCount() == 0) {
        delete holding;
        return;
    }
    holding->setText(0, tr("%n lines that hold a cover", nullptr, holding->childCount()));
    holding->setFlags(holding->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate);
    addTopLevelItem(holding);
    holding->setExpanded(wasOpen);
}

void SeamLineList::tick(const Design& design, bool ticked)
{
    const std::set<ElementId> usual = ticked ? linesToCut(design) : std::set<ElementId>();
    const QSignalBlocker quiet(this);
    for (QTreeWidgetItem* line : items())
        line->setCheckState(0, usual.contains(curveOf(*line)) ? Qt::Checked : Qt::Unchecked);
}

SeamLineList::States SeamLineList::states() const
{
    States states;
    for (const QTreeWidgetItem* line : items())
        states[line->data(0, Qt::UserRole).toUInt()] = line->checkState(0);
    return states;
}

void SeamLineList::setStates(const States& states)
{
    const QSignalBlocker quiet(this);
    for (QTreeWidgetItem* line : items())
        if (const auto known = states.find(line->data(0, Qt::UserRole).toUInt()); known != states.end())
            line->setCheckState(0, known->second);
}

std::vector<ElementId> SeamLineList::tickedCurves() const
{
    std::vector<ElementId> curves;
    for (const QTreeWidgetItem* item : items())
        if (item->checkState(0) == Qt::Checked)
            curves.push_back(curveOf(*item));
    return curves;
}

std::vector<FormLine> SeamLineList::ticked(const Design& design) const
{
    Design ticked;
    for (const ElementId id : tickedCurves())
        if (const ElementPtr curve = design.element(id))
            ticked = ticked.with({{}, {{id, nullptr, curve}}});
    return linesOf(ticked);
}

/// Not the heading of those that hold a cover.
std::vector<QTreeWidgetItem*> SeamLineList::items() const
{
    std::vector<QTreeWidgetItem*> items;
    for (int row = 0; row < topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = topLevelItem(row);
        if (item->data(0, Qt::UserRole).isValid())
            items.push_back(item);
        for (int k = 0; k < item->childCount(); ++k)
            items.push_back(item->child(k));
    }
    return items;
}

} // namespace bolster
