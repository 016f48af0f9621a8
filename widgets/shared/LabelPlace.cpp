#include "LabelPlace.h"

#include <QLineF>
#include <QTransform>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr int sampleCount = 160;
constexpr int gridCells = 18;
constexpr double labelAspects[] = {3, 7};
constexpr double comfort = 1.2;   // room that looks better than just enough
constexpr double leastLean = 0.2; // radians from lying or upright
constexpr double uprightAngle = std::numbers::pi / 2;
constexpr double leastStretch = 1.5; // length to width of what leans

using SamplePoints = std::vector<Vec2>;

/// Points at equal distances along the polygon.
SamplePoints sampledOutline(const QPolygonF& polygon)
{
    double around = 0;
    for (qsizetype i = 1; i < polygon.size(); ++i)
        around += QLineF(polygon[i - 1], polygon[i]).length();
    SamplePoints points;
    double left = 0; // to the next point
    for (qsizetype i = 1; i < polygon.size(); ++i) {
        const QLineF edge(polygon[i - 1], polygon[i]);
        for (; left < edge.length(); left += around / sampleCount) {
            const QPointF p = edge.pointAt(left / edge.length());
            points.emplace_back(p.x(), p.y());
        }
        left -= edge.length();
    }
    return points;
}

/// Per aspect half the height of the largest box around p that holds no point of the outline; negative outside.
std::array<double, std::size(labelAspects)> roomAt(const SamplePoints& outline, const Vec2& p)
{
    std::array<double, std::size(labelAspects)> room;
    room.fill(INFINITY);
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[j];
        const Vec2 away = (p - a).cwiseAbs();
        for (std::size_t k = 0; k < room.size(); ++k)
            room[k] = std::min(room[k], std::max(away.x() / labelAspects[k], away.y()));
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    for (double& r : room)
        r = inside ? r : -r;
    return room;
}

/// Area's middle and the direction in which it is longest, with how much longer it is.
struct Shape {
    Vec2 middle = Vec2::Zero();
    double angle = 0;
    double stretch = 1;
};

Shape shapeOf(const SamplePoints& outline)
{
    Shape shape;
    double area = 0, xx = 0, xy = 0, yy = 0;
    const Vec2 origin = outline.front();
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2 a = outline[j] - origin, b = outline[i] - origin;
        const double twice = a.x() * b.y() - a.y() * b.x();
        area += twice / 2;
        shape.middle += twice / 6 * (a + b);
        xx += twice / 12 * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
        yy += twice / 12 * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y());
        xy += twice / 24 * (a.x() * b.y() + 2 * a.x() * a.y() + 2 * b.x() * b.y() + b.x() * a.y());
    }
    if (area == 0)
        return {origin, 0, 1};
    shape.middle /= area;
    xx = xx / area - shape.middle.x() * shape.middle.x();
    yy = yy / area - shape.middle.y() * shape.middle.y();
    xy = xy / area - shape.middle.x() * shape.middle.y();
    shape.middle += origin;
    shape.angle = 0.5 * std::atan2(2 * xy, xx - yy);
    const double mean = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
    shape.stretch = mean > spread ? std::sqrt((mean + spread) / (mean - spread)) : 1;
    return shape;
}

} // namespace

void LabelPlace::search(const QPolygonF& outline, double angle, std::vector<Row>& rows)
{
    QTransform turn;
    turn.rotateRadians(-angle);
    const SamplePoints points = sampledOutline(turn.map(outline));
    if (points.size() < 3)
        return;
    Box2 box;
    for (const Vec2& p : points)
        box.extend(p);
    const Vec2 middle = shapeOf(points).middle;
    std::array<std::vector<Place>, std::size(labelAspects)> found;
    for (int i = 0; i <= gridCells + 1; ++i)
        for (int j = 0; j <= gridCells; ++j) {
            const Vec2 share(static_cast<double>(i) / gridCells, static_cast<double>(j) / gridCells);
            const Vec2 p = i > gridCells ? middle : Vec2(box.min() + box.sizes().cwiseProduct(share));
            const auto room = roomAt(points, p);
            for (std::size_t k = 0; k < room.size(); ++k)
                if (room[k] > 0)
                    found[k].push_back({p, angle, room[k]});
        }
    const Eigen::Rotation2Dd back(angle);
    for (std::size_t k = 0; k < found.size(); ++k) {
        std::ranges::sort(found[k], {}, [&](const Place& place) { return (place.centre - middle).norm(); });
        Row row{angle, labelAspects[k], {}};
        for (Place& place : found[k])
            if (row.places.empty() || place.room > row.places.back().room) {
                place.centre = back * place.centre;
                row.places.push_back(place);
            }
        rows.push_back(std::move(row));
    }
}

LabelPlace LabelPlace::inside(const QPolygonF& outline)
{
    LabelPlace label;
    search(outline, 0, label.m_rows);
    search(outline, uprightAngle, label.m_rows);
    const SamplePoints points = sampledOutline(outline);
    if (points.size() < 3)
        return label;
    const Shape shape = shapeOf(points);
    const double lean = std::abs(std::remainder(shape.angle, std::numbers::pi / 2));
    if (lean > leastLean && shape.stretch > leastStretch)
        search(outline, shape.angle, label.m_rows);
    return label;
}

std::optional<LabelPlace::Place> LabelPlace::place(const QSizeF& text) const
{
    std::optional<Place> best;
    double least = INFINITY;
    for (const Row& row : m_rows) {
        const double needed = std::max(text.width() / 2 / row.aspect, text.height() / 2);
        const auto found = [&](double room) {
            return std::ranges::find_if(row.places, [room](const Place& place) { return place.room >= room; });
        };
        auto place = found(comfort * needed);
        if (place == row.places.end())
            place = found(needed);
        if (place == row.places.end())
            continue;
        // Half the width of the widest line away from the middle is as bad as a line that is turned.
        const double away =
            (place->centre - row.places.front().centre).norm() / (row.aspect * row.places.back().room);
        const double cost = away + (row.angle == 0 ? 0 : row.angle == uprightAngle ? 0.5 : 0.6);
        if (cost < least) {
            least = cost;
            best = *place;
        }
    }
    return best;
}

void LabelPlace::move(const Vec2& by)
{
    for (Row& row : m_rows)
        for (Place& place : row.places)
            place.centre += by;
}

} // namespace bolster
