#include "TriangleTree.h"

#include "NearestOnTriangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bolster {

namespace {

constexpr double farAway = 2; // radii: from there on a node counts as a dipole

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

TriangleTree::TriangleTree(const std::vector<Triangle>& triangles, const std::stop_token& stop)
{
    std::vector<std::uint32_t> all(triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    m_boxes.build(
        all, [&](std::uint32_t i) { return triangles[i]; }, stop);
    m_triangles.reserve(triangles.size());
    for (const std::uint32_t i : m_boxes.order())
        m_triangles.push_back(triangles[i]);
    m_dipoles.reserve(m_boxes.nodes().size());
    for (const auto& node : m_boxes.nodes()) {
        if (stop.stop_requested())
            return;
        m_dipoles.push_back(dipoleOf(node));
    }
    if (!m_boxes.nodes().empty())
        m_box = m_boxes.nodes().front().box;
}

TriangleTree::Dipole TriangleTree::dipoleOf(const BoxTree<double>::Node& node) const
{
    Dipole dipole;
    double area = 0;
    const auto begin = m_triangles.begin() + node.first, end = begin + node.count;
    for (auto t = begin; t != end; ++t) {
        const auto& [a, b, c] = *t;
        const Vec3 normal = 0.5 * (b - a).cross(c - a);
        dipole.moment += normal;
        dipole.centre += normal.norm() / 3 * (a + b + c);
        area += normal.norm();
    }
    dipole.centre = area > 0 ? Vec3(dipole.centre / area) : node.box.center();
    for (auto t = begin; t != end; ++t)
        for (const Vec3& corner : *t)
            dipole.radius = std::max(dipole.radius, (corner - dipole.centre).norm());
    return dipole;
}

double TriangleTree::windingNumber(const Vec3& point) const
{
    double angle = 0;
    AngleSum near;
    for (std::size_t i = 0; i < m_dipoles.size();) {
        const Dipole& dipole = m_dipoles[i];
        const Vec3 way = dipole.centre - point;
        const double squared = way.squaredNorm();
        const BoxTree<double>::Node& node = m_boxes.nodes()[i];
        if (squared > farAway * farAway * dipole.radius * dipole.radius) {
            angle += dipole.moment.dot(way) / (squared * std::sqrt(squared));
            i = node.next;
            continue;
        }
        if (node.isLeaf())
            for (std::uint32_t t = node.first; t < node.first + node.count; ++t)
                near.add(m_triangles[t], point);
        ++i;
    }
    return (angle + near.total()) / (4 * std::numbers::pi);
}

double TriangleTree::distance(const Vec3& point, double within) const
{
    double best = within * within;
    const auto gap = [&](const Box3& box) { return box.squaredExteriorDistance(point); };
    m_boxes.walk(gap, best, [&](std::uint32_t place) {
        const auto& [a, b, c] = m_triangles[place];
        best = std::min(best, (nearestOnTriangle(point, a, b, c) - point).squaredNorm());
        return false;
    });
    return std::min(within, std::sqrt(best));
}

} // namespace bolster
