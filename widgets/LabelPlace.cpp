#include "LabelPlace.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bolster {

namespace {

using Points = std::vector<Vec2>;

/// Points at equal distances along the polygon, with x and y stretched.
Points sampled(const QPolygonF& polygon, int count, double stretchX, double stretchY)
{
    double around = 0;
    for (qsizetype i = 1; i < polygon.size(); ++i)
        around += QLineF(polygon[i - 1], polygon[i]).length();
    Points points;
    double left = 0; // to the next point
    for (qsizetype i = 1; i < polygon.size(); ++i) {
        const QLineF edge(polygon[i - 1], polygon[i]);
        for (; left < edge.length(); left += around / count) {
            const QPointF p = edge.pointAt(left / edge.length());
            points.emplace_back(p.x() * stretchX, p.y() * stretchY);
        }
        left -= edge.length();
    }
    return points;
}

/// Half the size of the largest square around p that holds no point of the outline; negative outside.
double depthInside(const Points& outline, const Vec2& p)
{
    double nearest = INFINITY;
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[j];
        nearest = std::min(nearest, (p - a).cwiseAbs().maxCoeff());
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside ? nearest : -nearest;
}

LabelPlace::Spot deepest(const Points& outline, Box2 box, int cells)
{
    LabelPlace::Spot best{box.center(), -INFINITY};
    const Vec2 middle = box.center();
    const double reach = std::max(box.sizes().norm(), 1e-9);
    double bestScore = -INFINITY;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const Vec2 share(static_cast<double>(i) / cells, static_cast<double>(j) / cells);
            const Vec2 p = box.min() + box.sizes().cwiseProduct(share);
            const double depth = depthInside(outline, p);
            // Among places that are about as good the one in the middle looks best.
            const double score = depth - 0.12 * std::abs(depth) * (p - middle).norm() / reach;
            if (score > bestScore) {
                bestScore = score;
                best = {p, depth};
            }
        }
    return best;
}

LabelPlace::Spot search(const QPolygonF& outline, double stretchX, double stretchY)
{
    const Points points = sampled(outline, 160, stretchX, stretchY);
    if (points.size() < 3)
        return {};
    Box2 box;
    for (const Vec2& p : points)
        box.extend(p);
    LabelPlace::Spot spot = deepest(points, box, 18);
    spot.centre = spot.centre.cwiseQuotient(Vec2(stretchX, stretchY));
    return spot;
}

} // namespace

bool LabelPlace::fits(const Spot& spot, const QSizeF& text)
{
    return std::max(text.width() / 2 / aspect, text.height() / 2) <= spot.room;
}

LabelPlace LabelPlace::inside(const QPolygonF& outline)
{
    return {search(outline, 1 / aspect, 1), search(outline, 1, 1 / aspect)};
}

} // namespace bolster
