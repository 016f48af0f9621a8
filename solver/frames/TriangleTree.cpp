#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr int leafSize = 3;
constexpr double farAway = 2; // radii: from there on a node counts as a dipole

/// Of a tree that is halved until the leaves are small.
std::size_t mostNodes(std::size_t triangles)
{
    std::size_t leaves = 1;
    while (leaves * leafSize < triangles)
        leaves *= 2;
    return 2 * leaves - 1;
}

/// A sum of solid angles. Each is twice the angle of a vector in the plane (Van Oosterom and Strackee, 1983); these
/// are multiplied as complex numbers, full turns counted, so that one arc tangent does for all.
class AngleSum {
public:
    void add(const TriangleTree::Triangle& triangle, const Vec3& point)
    {
        const Vec3 a = triangle[0] - point, b = triangle[1] - point, c = triangle[2] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        const double x = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        const double y = a.dot(b.cross(c));
        const double length = std::abs(x) + std::abs(y);
        if (!(length > 0))
            return; // a corner
        const double before = m_y;
        const double u = (m_x * x - m_y * y) / length, v = (m_x * y + m_y * x) / length;
        const double scale = 1 / (std::abs(u) + std::abs(v));
        m_x = u * scale;
        m_y = v * scale;
        if (before > 0 && y > 0 && m_y <= 0)
            ++m_turns;
        else if (before < 0 && y < 0 && m_y >= 0)
            --m_turns;
    }
    double total() const { return 2 * (std::atan2(m_y, m_x) + 2 * std::numbers::pi * m_turns); }

private:
    double m_x = 1;
    double m_y = 0;
    int m_turns = 0;
};

} // namespace

// Source: Ericson, "Real-Time Collision Detection", 5.1.5.
Vec3 nearestPoint(const TriangleTree::Triangle& triangle, const Vec3& point)
{
    const auto& [a, b, c] = triangle;
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = ab.dot(point - a), d2 = ac.dot(point - a);
    if (d1 <= 0 && d2 <= 0)
        return a;
    const double d3 = ab.dot(point - b), d4 = ac.dot(point - b);
    if (d3 >= 0 && d4 <= d3)
        return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return a + d1 / (d1 - d3) * ab;
    const double d5 = ab.dot(point - c), d6 = ac.dot(point - c);
    if (d6 >= 0 && d5 <= d6)
        return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    return a + (vb * ab + vc * ac) / (va + vb + vc);
}

TriangleTree::TriangleTree(std::vector<Triangle> triangles, const std::stop_token& stop)
    : m_triangles(std::move(triangles))
{
    for (const Triangle& triangle : m_triangles)
        for (const Vec3& corner : triangle)
            m_box.extend(corner);
    if (m_triangles.empty())
        return;
    m_nodes.reserve(mostNodes(m_triangles.size()));
    build(0, static_cast<int>(m_triangles.size()), stop);
}

void TriangleTree::build(int begin, int end, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return;
    const auto self = m_nodes.size();
    m_nodes.push_back(summary(begin, end));
    if (end - begin <= leafSize) {
        m_nodes[self].count = end - begin;
    } else {
        int axis = 0;
        m_nodes[self].box.sizes().maxCoeff(&axis);
        const auto place = [axis](const Triangle& t) { return t[0][axis] + t[1][axis] + t[2][axis]; };
        const int middle = begin + (end - begin) / 2;
        std::nth_element(m_triangles.begin() + begin, m_triangles.begin() + middle, m_triangles.begin() + end,
                         [&](const Triangle& a, const Triangle& b) { return place(a) < place(b); });
        build(begin, middle, stop);
        build(middle, end, stop);
    }
    m_nodes[self].next = static_cast<int>(m_nodes.size());
}

TriangleTree::Node TriangleTree::summary(int begin, int end) const
{
    Node node;
    node.first = begin;
    double area = 0;
    for (int t = begin; t < end; ++t) {
        const auto& [a, b, c] = m_triangles[t];
        const Vec3 normal = 0.5 * (b - a).cross(c - a);
        node.dipole += normal;
        node.centre += normal.norm() / 3 * (a + b + c);
        area += normal.norm();
        for (const Vec3& corner : m_triangles[t])
            node.box.extend(corner);
    }
    node.centre = area > 0 ? Vec3(node.centre / area) : node.box.center();
    for (int t = begin; t < end; ++t)
        for (const Vec3& corner : m_triangles[t])
            node.radius = std::max(node.radius, (corner - node.centre).norm());
    return node;
}

double TriangleTree::windingNumber(const Vec3& point) const
{
    double angle = 0;
    AngleSum near;
    for (int i = 0; i < std::ssize(m_nodes);) {
        const Node& node = m_nodes[i];
        const Vec3 way = node.centre - point;
        const double squared = way.squaredNorm();
        if (squared > farAway * farAway * node.radius * node.radius) {
            angle += node.dipole.dot(way) / (squared * std::sqrt(squared));
            i = node.next;
            continue;
        }
        for (int t = node.first; t < node.first + node.count; ++t)
            near.add(m_triangles[t], point);
        ++i;
    }
    return (angle + near.total()) / (4 * std::numbers::pi);
}

double TriangleTree::distance(const Vec3& point, double within) const
{
    double best = within * within;
    for (int i = 0; i < std::ssize(m_nodes);) {
        const Node& node = m_nodes[i];
        if (node.box.squaredExteriorDistance(point) >= best) {
            i = node.next;
            continue;
        }
        for (int t = node.first; t < node.first + node.count; ++t)
            best = std::min(best, (nearestPoint(m_triangles[t], point) - point).squaredNorm());
        ++i;
    }
    return std::min(within, std::sqrt(best));
}

} // namespace bolster
