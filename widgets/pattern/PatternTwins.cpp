#include "PatternTwins.h"

#include "PatternScene.h"
#include "ViewColors.h"

#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

const std::vector<Vec2>* curvePointsOf(const PatternScene& scene, ElementId id)
{
    if (const PatternPatch* patch = scene.patch(id))
        return &patch->points;
    const auto line = scene.lines().find(id);
    return line == scene.lines().end() ? nullptr : &line->second.points;
}

} // namespace

PatternTwins PatternTwins::of(const Design& design)
{
    PatternTwins twins;
    twins.symmetry = design.settings().symmetry;
    for (const auto& [follower, original] : twinPairs(design)) {
        const std::vector<int>& released = twinLink(*design.element(follower))->released;
        for (const auto& [id, other] : {std::pair(follower, original), std::pair(original, follower)}) {
            twins.others[id] = other;
            twins.released[id] = {released.begin(), released.end()};
        }
    }
    return twins;
}

bool PatternTwins::isReleased(ElementId id, int point) const
{
    const auto found = released.find(id);
    return found != released.end() && found->second.contains(point);
}

std::optional<Vec2> PatternTwins::follower(const PatternScene& scene, ElementId id, int point) const
{
    const auto other = others.find(id);
    if (other == others.end() || isReleased(id, point))
        return std::nullopt;
    const std::vector<Vec2>* points = curvePointsOf(scene, other->second);
    if (!points || point < 0 || static_cast<std::size_t>(point) >= points->size())
        return std::nullopt;
    return (*points)[static_cast<std::size_t>(point)];
}

void paintSymmetryAxis(QPainter& painter, const Symmetry& symmetry, const PatternTransform& transform,
                       const QSizeF& size, const ViewColors& colors)
{
    const double angle = symmetry.axisAngle() * M_PI / 180;
    const Vec2 along(std::cos(angle), std::sin(angle));
    const Vec2 origin = symmetry.axisUsable() ? symmetry.axisPoint : Vec2(0, 0);
    // From the point nearest to the middle of the view, so that the dashes stay few however far it is away.
    const Box2 visible = transform.visible(size);
    const Vec2 middle = origin + along * along.dot(visible.center() - origin);
    const Vec2 half = along * visible.diagonal().norm();
    QPen pen(mixed(colors.canvas, colors.accent, 0.75), 1.3, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({14, 4, 2, 4});
    painter.setPen(pen);
    painter.drawLine(transform.toPixels(middle - half), transform.toPixels(middle + half));
}

void paintTwinMark(QPainter& painter, QPointF at, bool exceptions, const QColor& color)
{
    constexpr double gap = 2;
    constexpr double width = 7;
    constexpr double height = 4.5;
    painter.setPen(QPen(color, 1, Qt::DashLine));
    painter.drawLine(at - QPointF(0, height + 2), at + QPointF(0, height + 2));
    painter.setPen(QPen(color, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const double side : {-1.0, 1.0}) {
        painter.setBrush(side < 0 ? QBrush(color) : QBrush(Qt::NoBrush));
        painter.drawPolygon(QPolygonF{at + QPointF(side * gap, height), at + QPointF(side * gap, -height),
                                      at + QPointF(side * (gap + width), height)});
    }
    if (exceptions) {
        painter.setPen(QPen(color, 1.2, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        painter.setBrush(Qt::NoBrush);
        const QPointF corner = at + QPointF(gap + width + 6, 0);
        painter.drawPolygon(QPolygonF{corner + QPointF(0, -3.5), corner + QPointF(3.5, 0), corner + QPointF(0, 3.5),
                                      corner + QPointF(-3.5, 0)});
    }
}

void paintReleasedPoint(QPainter& painter, QPointF at, double size)
{
    const double half = 0.5 * size + 1;
    painter.drawPolygon(
        QPolygonF{at + QPointF(0, -half), at + QPointF(half, 0), at + QPointF(0, half), at + QPointF(-half, 0)});
    QPen ring = painter.pen();
    ring.setWidthF(1);
    ring.setDashPattern({2.5, 2});
    painter.setPen(ring);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, half + 4, half + 4);
}

void paintFollower(QPainter& painter, QPointF at, const ViewColors& colors)
{
    painter.setPen(QPen(colors.accent, 1.8));
    QColor inside = colors.accent;
    inside.setAlphaF(0.25F);
    painter.setBrush(inside);
    painter.drawEllipse(at, 7.5, 7.5);
    painter.setBrush(colors.accent);
    painter.drawEllipse(at, 1.5, 1.5);
}

} // namespace bolster
