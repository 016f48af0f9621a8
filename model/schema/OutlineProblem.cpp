// What can be wrong with the shape of an outline.
#include "DesignCheck.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double smallestSize = 1e-3; // mm

int distinctPoints(const BSpline2& outline)
{
    std::vector<std::pair<double, double>> points;
    for (const Vec2& point : outline.points())
        points.emplace_back(point.x(), point.y());
    std::sort(points.begin(), points.end());
    return static_cast<int>(std::unique(points.begin(), points.end()) - points.begin());
}

// Whether all points lie on one line.
bool flat(const BSpline2& outline)
{
    const Vec2 origin = outline.points().front();
    Vec2 farthest = origin;
    for (const Vec2& point : outline.points())
        if ((point - origin).norm() > (farthest - origin).norm())
            farthest = point;
    const Vec2 line = farthest - origin;
    return std::all_of(outline.points().begin(), outline.points().end(), [&](const Vec2& point) {
        return std::abs(line.x() * (point - origin).y() - line.y() * (point - origin).x()) <=
               1e-9 * line.squaredNorm();
    });
}

std::string coordinates(const Vec2& point)
{
    return std::string("(").append(numberText(point.x())).append(", ").append(numberText(point.y())).append(")");
}

} // namespace

std::optional<Message> outlineProblem(const BSpline2& outline)
{
    if (outline.empty() || !outline.closed())
        return Message{QT_TRANSLATE_NOOP("Message", "an outline must be a closed curve")};
    const double size = outline.boundingBox().diagonal().norm();
    if (distinctPoints(outline) < 3 || !(size >= smallestSize))
        return Message{QT_TRANSLATE_NOOP("Message", "the outline needs at least three points in different places")};
    if (flat(outline))
        return Message{QT_TRANSLATE_NOOP("Message",
                                         "all points of the outline lie on one line, it encloses no area; "
                                         "move one of them")};
    if (const auto crossing = selfIntersection(outline))
        return Message{QT_TRANSLATE_NOOP("Message",
                                         "the outline crosses or touches itself near %1; move its points "
                                         "apart there"),
                       {coordinates(*crossing)}};
    if (!(std::abs(outline.signedArea()) > 1e-9 * size * size))
        return Message{QT_TRANSLATE_NOOP("Message", "the outline encloses no area")};
    return std::nullopt;
}

} // namespace bolster
