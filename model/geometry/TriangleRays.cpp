#include "TriangleRays.h"

#include "NearestOnTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr float rayBoxPadding = 1e-3F; ///< of boxes, mm: rays along their walls are inside
constexpr float rayInfinite = std::numeric_limits<float>::infinity();

/// Where the ray meets the triangle, in lengths of the direction; rayInfinite if it does not (Moeller, Trumbore
/// 1997).
float meeting(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
              const BoxTree<float>::Triangle& corners)
{
    const auto& [a, b, c] = corners;
    const Eigen::Vector3f e1 = b - a, e2 = c - a, p = direction.cross(e2);
    const float determinant = e1.dot(p);
    if (!(std::abs(determinant) > 1e-12f))
        return rayInfinite;
    const Eigen::Vector3f fromA = origin - a, q = fromA.cross(e1);
    const float u = fromA.dot(p) / determinant, v = direction.dot(q) / determinant;
    const float t = e2.dot(q) / determinant;
    return u >= -1e-5f && v >= -1e-5f && u + v <= 1.00001f && t > 0 ? t : rayInfinite;
}

} // namespace

TriangleRays::Boxes::Triangle TriangleRays::cornersOf(const Triangle& triangle) const
{
    return {m_points[triangle[0]], m_points[triangle[1]], m_points[triangle[2]]};
}

void TriangleRays::build(std::vector<Vec3f> points, std::vector<Triangle> triangles)
{
    m_points = std::move(points);
    std::vector<std::uint32_t> sound;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (std::ranges::all_of(triangles[i], [&](std::uint32_t corner) { return corner < m_points.size(); }))
            sound.push_back(i);
    m_boxes.build(sound, [&](std::uint32_t i) { return cornersOf(triangles[i]); });
    m_triangles.clear();
    for (const std::uint32_t i : m_boxes.order())
        m_triangles.push_back(triangles[i]);
}

void TriangleRays::move(std::vector<Vec3f> points)
{
    if (points.size() != m_points.size())
        return;
    m_points = std::move(points);
    m_boxes.fit([this](std::uint32_t place) { return cornersAt(place); });
}

/// Where a ray enters a box, in lengths of its direction; infinite if it passes.
class TriangleRays::Entry {
public:
    Entry(const Vec3f& origin, const Vec3f& direction)
        : m_origin(origin.array())
        // A ray along a wall of a box must not become 0 times infinity.
        , m_inverse(direction.array().unaryExpr([](float d) { return 1 / (std::abs(d) > 1e-12F ? d : 1e-12F); }))
    {}

    float operator()(const Boxes::Box& box) const
    {
        const Eigen::Array3f a = (box.min().array() - rayBoxPadding - m_origin) * m_inverse,
                             b = (box.max().array() + rayBoxPadding - m_origin) * m_inverse;
        const float in = std::max(a.min(b).maxCoeff(), 0.F), out = a.max(b).minCoeff();
        return in <= out * 1.00001F ? in : rayInfinite;
    }

private:
    Eigen::Array3f m_origin, m_inverse;
};

/// How far a ray that starts outside may go without meeting anything.
float TriangleRays::approach(const Vec3f& origin, const Vec3f& direction) const
{
    if (m_boxes.nodes().empty())
        return 0;
    const Boxes::Box& all = m_boxes.nodes().front().box;
    const float before = (all.center() - origin).dot(direction.normalized()) - 1.01F * all.diagonal().norm() / 2;
    return std::isfinite(before) ? std::max(0.F, before / direction.norm()) : 0;
}

std::optional<TriangleRays::Hit> TriangleRays::first(const Vec3f& farOrigin, const Vec3f& direction) const
{
    // From far away single precision misses triangles along their edges.
    const float skipped = approach(farOrigin, direction);
    const Vec3f origin = farOrigin + skipped * direction;
    std::optional<Hit> best;
    float reach = rayInfinite;
    m_boxes.walk(Entry(origin, direction), reach, [&](std::uint32_t place) {
        if (const float at = meeting(origin, direction, cornersAt(place)); at < reach) {
            reach = at;
            best = Hit{m_boxes.order()[place], skipped + at};
        }
        return false;
    });
    return best;
}

std::optional<TriangleRays::Nearest> TriangleRays::nearest(const Vec3f& point, float reach) const
{
    std::optional<Nearest> best;
    float square = reach * reach;
    const auto gap = [&](const Boxes::Box& box) { return box.squaredExteriorDistance(point); };
    m_boxes.walk(gap, square, [&](std::uint32_t place) {
        const auto [a, b, c] = cornersAt(place);
        const Vec3f on = nearestOnTriangle(point, a, b, c);
        if (const float now = (on - point).squaredNorm(); now < square) {
            square = now;
            best = Nearest{m_boxes.order()[place], on};
        }
        return false;
    });
    return best;
}

bool TriangleRays::blocked(const Vec3f& origin, const Vec3f& direction, float reach) const
{
    bool found = false;
    m_boxes.walk(Entry(origin, direction), reach, [&](std::uint32_t place) {
        found = meeting(origin, direction, cornersAt(place)) < reach;
        return found;
    });
    return found;
}

} // namespace bolster
