#include "PatternTrims.h"

#include "CurvePath.h"
#include "FabricShown.h"
#include "TrimRows.h"

#include <QPolygonF>

namespace bolster {

namespace {

QPainterPath inLayout(const TrimRow& row, const Patch& patch)
{
    QPolygonF points;
    for (const Vec2& p : row.points)
        points << toPoint(toLayout(patch, p));
    QPainterPath path;
    path.addPolygon(points);
    if (row.closed)
        path.closeSubpath();
    return path;
}

QColor colorOf(const Design& design, ElementId fabric)
{
    const Fabric* found = design.find<Fabric>(fabric);
    return found ? QColor(QString::fromStdString(found->color)) : QColor(Qt::gray);
}

} // namespace

void PatternTrims::update(const Design& design, std::set<ElementId> owners, const std::set<ElementId>& changed)
{
    for (const auto& [id, element] : design.elements())
        if (const SeamTrim* trim = seamTrim(*element); trim && changed.contains(trim->pipingFabric))
            owners.insert(id);
    for (const ElementId owner : owners) {
        m_marks.erase(owner);
        add(design, owner);
    }
}

void PatternTrims::add(const Design& design, ElementId owner)
{
    const ElementPtr element = design.element(owner);
    const SeamTrim* trim = element ? seamTrim(*element) : nullptr;
    if (!trim || !trim->hasTrimmings())
        return;
    const auto put = [&](const TrimRow& row, const QColor& color, double width, double stitch) {
        if (const Patch* patch = design.find<Patch>(row.patch))
            m_marks.emplace(owner, PatternTrim{row.patch, inLayout(row, *patch), color, width, stitch});
    };
    for (const TrimRow& row : pipingRows(design, *element)) {
        const ElementId fabric =
            trim->pipingFabric != noElement ? trim->pipingFabric : fabricShown(design, row.patch);
        put(row, colorOf(design, fabric), 2 * trim->pipingRadius, 0);
    }
    for (const TrimRow& row : stitchRows(design, *element))
        put(row, QColor(QString::fromStdString(trim->thread)), trim->threadWidth, trim->stitchLength);
}

} // namespace bolster
