#include "TriangleRays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bolster {

namespace {

constexpr std::uint32_t rayLeafSize = 4;
constexpr float rayBoxPadding = 1e-3F; ///< of boxes, mm: rays along their walls are inside
constexpr float rayInfinite = std::numeric_limits<float>::infinity();

/// Where the ray meets the triangle, in lengths of the direction; rayInfinite if it does not (Moeller, Trumbore
/// 1997).
float meeting(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, const Eigen::Vector3f& a,
              const Eigen::Vector3f& b, const Eigen::Vector3f& c)
{
    const Eigen::Vector3f e1 = b - a, e2 = c - a, p = direction.cross(e2);
    const float determinant = e1.dot(p);
    if (!(std::abs(determinant) > 1e-12f))
        return rayInfinite;
    const Eigen::Vector3f fromA = origin - a, q = fromA.cross(e1);
    const float u = fromA.dot(p) / determinant, v = direction.dot(q) / determinant;
    const float t = e2.dot(q) / determinant;
    return u >= -1e-5f && v >= -1e-5f && u + v <= 1.00001f && t > 0 ? t : rayInfinite;
}

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Eigen::Vector3f nearestPoint(const Eigen::Vector3f& p, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                             const Eigen::Vector3f& c)
{
    const Eigen::Vector3f ab = b - a, ac = c - a, bc = c - b, ap = p - a, bp = p - b, cp = p - c;
    const float d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
                d6 = ac.dot(cp);
    if (d1 <= 0 && d2 <= 0)
        return a;
    if (d3 >= 0 && d4 <= d3)
        return b;
    if (d6 >= 0 && d5 <= d6)
        return c;
    const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return a + d1 / (d1 - d3) * ab;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return a + d2 / (d2 - d6) * ac;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * bc;
    const float all = va + vb + vc;
    return all > 0 ? Eigen::Vector3f(a + vb / all * ab + vc / all * ac) : a;
}

} // namespace

void TriangleRays::build(std::vector<Vec3f> points, std::vector<Triangle> triangles)
{
    m_points = std::move(points);
    m_nodes.clear();
    m_ids.clear();
    std::vector<Eigen::Array3f> centres(triangles.size(), Eigen::Array3f::Zero());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (std::any_of(triangles[i].begin(), triangles[i].end(), [&](auto k) { return k >= m_points.size(); }))
            continue;
        m_ids.push_back(i);
        for (const std::uint32_t corner : triangles[i])
            if (m_points[corner].allFinite())
                centres[i] += m_points[corner].array() / 3;
    }
    if (!m_ids.empty())
        split(0, static_cast<std::uint32_t>(m_ids.size()), centres);
    m_triangles.clear();
    for (const std::uint32_t id : m_ids)
        m_triangles.push_back(triangles[id]);
    fitBoxes();
}

void TriangleRays::move(std::vector<Vec3f> points)
{
    if (points.size() != m_points.size())
        return;
    m_points = std::move(points);
    fitBoxes();
}

/// Makes the node for these triangles: halves along the longest side of their centres' box.
std::uint32_t TriangleRays::split(std::uint32_t first, std::uint32_t count, std::vector<Eigen::Array3f>& centres)
{
    const auto node = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes.push_back({});
    if (count <= rayLeafSize) {
        m_nodes[node].first = first;
        m_nodes[node].count = count;
        return node;
    }
    Eigen::Array3f low = centres[m_ids[first]], high = low;
    for (std::uint32_t i = first; i < first + count; ++i) {
        low = low.min(centres[m_ids[i]]);
        high = high.max(centres[m_ids[i]]);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const auto begin = m_ids.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count,
                     [&](std::uint32_t a, std::uint32_t b) { return centres[a][axis] < centres[b][axis]; });
    split(first, count / 2, centres);
    const std::uint32_t right = split(first + count / 2, count - count / 2, centres);
    m_nodes[node].first = right;
    return node;
}

void TriangleRays::fitBox(Node& node) const
{
    node.low = Eigen::Array3f::Constant(rayInfinite);
    node.high = Eigen::Array3f::Constant(-rayInfinite);
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        for (const std::uint32_t corner : m_triangles[i])
            if (m_points[corner].allFinite()) {
                node.low = node.low.min(m_points[corner].array());
                node.high = node.high.max(m_points[corner].array());
            }
    node.low -= rayBoxPadding;
    node.high += rayBoxPadding;
}

void TriangleRays::fitBoxes()
{
    for (std::size_t i = m_nodes.size(); i-- > 0;) { // children come after their parent
        Node& node = m_nodes[i];
        if (node.count > 0) {
            fitBox(node);
        } else {
            const Node &left = m_nodes[i + 1], &right = m_nodes[node.first];
            node.low = left.low.min(right.low);
            node.high = left.high.max(right.high);
        }
    }
}

/// Visits the triangles of all leaves that are less far than `reach`, the near ones first. `distance` of a node is
/// to be infinite where nothing is wanted of it. Ends when a visit returns true.
template <class Distance, class Visit>
void TriangleRays::walk(const Distance& distance, const float& reach, const Visit& visit) const
{
    if (m_nodes.empty())
        return;
    std::array<std::uint32_t, 64> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t index = waiting[--count];
        const Node& node = m_nodes[index];
        if (!(distance(node) < reach))
            continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Triangle& t = m_triangles[i];
            if (visit(m_ids[i], m_points[t[0]], m_points[t[1]], m_points[t[2]]))
                return;
        }
        if (node.count > 0)
            continue;
        const bool leftFirst = distance(m_nodes[index + 1]) < distance(m_nodes[node.first]);
        waiting[count++] = leftFirst ? node.first : index + 1;
        waiting[count++] = leftFirst ? index + 1 : node.first;
    }
}

/// Where a ray enters the box of a node, in lengths of its direction; infinite if it passes.
class TriangleRays::Entry {
public:
    Entry(const Vec3f& origin, const Vec3f& direction)
        : m_origin(origin.array())
        // A ray along a wall of a box must not become 0 times infinity.
        , m_inverse(direction.array().unaryExpr([](float d) { return 1 / (std::abs(d) > 1e-12F ? d : 1e-12F); }))
    {}

    float operator()(const Node& node) const
    {
        const Eigen::Array3f a = (node.low - m_origin) * m_inverse, b = (node.high - m_origin) * m_inverse;
        const float in = std::max(a.min(b).maxCoeff(), 0.F), out = a.max(b).minCoeff();
        return in <= out * 1.00001F ? in : rayInfinite;
    }

private:
    Eigen::Array3f m_origin, m_inverse;
};

/// How far a ray that starts outside may go without meeting anything.
float TriangleRays::approach(const Vec3f& origin, const Vec3f& direction) const
{
    if (m_nodes.empty())
        return 0;
    const Eigen::Array3f middle = (m_nodes[0].low + m_nodes[0].high) / 2;
    const float radius = (m_nodes[0].high - m_nodes[0].low).matrix().norm() / 2;
    const float before = (middle.matrix() - origin).dot(direction.normalized()) - 1.01F * radius;
    return std::isfinite(before) ? std::max(0.F, before / direction.norm()) : 0;
}

std::optional<TriangleRays::Hit> TriangleRays::first(const Vec3f& farOrigin, const Vec3f& direction) const
{
    // From far away single precision misses triangles along their edges.
    const float skipped = approach(farOrigin, direction);
    const Vec3f origin = farOrigin + skipped * direction;
    std::optional<Hit> best;
    float reach = rayInfinite;
    walk(Entry(origin, direction), reach,
         [&](std::uint32_t triangle, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
             if (const float at = meeting(origin, direction, a, b, c); at < reach) {
                 reach = at;
                 best = Hit{triangle, skipped + at};
             }
             return false;
         });
    return best;
}

std::optional<TriangleRays::Nearest> TriangleRays::nearest(const Vec3f& point, float reach) const
{
    const auto gap = [&](const Node& node) { // squared
        return (node.low - point.array()).max(point.array() - node.high).max(0.F).matrix().squaredNorm();
    };
    std::optional<Nearest> best;
    float bestSquare = reach * reach;
    walk(gap, bestSquare, [&](std::uint32_t triangle, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        const Vec3f on = nearestPoint(point, a, b, c);
        if (const float square = (on - point).squaredNorm(); square < bestSquare) {
            bestSquare = square;
            best = Nearest{triangle, on};
        }
        return false;
    });
    return best;
}

bool TriangleRays::blocked(const Vec3f& origin, const Vec3f& direction, float reach) const
{
    bool found = false;
    walk(Entry(origin, direction), reach, [&](std::uint32_t, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        found = meeting(origin, direction, a, b, c) < reach;
        return found;
    });
    return found;
}

} // namespace bolster
