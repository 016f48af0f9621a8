#include "Shells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bolster {

namespace {

/// Of each point the least one that it is connected with.
std::vector<std::uint32_t> connectedPoints(const TriangleMesh& solid)
{
    std::vector<std::uint32_t> root(solid.points.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto rootOf = [&](std::uint32_t point) {
        while (root[point] != point)
            point = root[point] = root[root[point]];
        return point;
    };
    for (const auto& [a, b, c] : solid.triangles)
        for (const std::uint32_t other : {b, c}) {
            const std::uint32_t one = rootOf(a), two = rootOf(other);
            root[std::max(one, two)] = std::min(one, two);
        }
    for (std::uint32_t point = 0; point < root.size(); ++point)
        root[point] = rootOf(point);
    return root;
}

} // namespace

std::vector<Shell> shellsOf(const TriangleMesh& solid)
{
    const std::vector<std::uint32_t> root = connectedPoints(solid);
    std::vector<Shell> shells;
    std::vector<std::size_t> shellOf(solid.points.size(), solid.points.size());
    for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
        const auto& [a, b, c] = solid.triangles[t];
        std::size_t& at = shellOf[root[a]];
        if (at == solid.points.size()) {
            at = shells.size();
            shells.emplace_back();
        }
        Shell& shell = shells[at];
        shell.triangles.push_back(t);
        for (const std::uint32_t corner : {a, b, c})
            shell.box.extend(solid.points[corner]);
        shell.volume += solid.points[a].dot(solid.points[b].cross(solid.points[c])) / 6;
    }
    return shells;
}

std::size_t dropSmallShells(TriangleMesh& solid, double volume)
{
    std::size_t dropped = 0;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Shell& shell : shellsOf(solid)) {
        if (std::abs(shell.volume) < volume) {
            dropped += shell.isVoid() ? 0 : 1;
            continue;
        }
        for (const std::uint32_t triangle : shell.triangles)
            triangles.push_back(solid.triangles[triangle]);
    }
    std::vector<std::uint32_t> numbers(solid.points.size(), 0); // from 1
    std::vector<Vec3> points;
    for (auto& triangle : triangles)
        for (std::uint32_t& corner : triangle) {
            if (numbers[corner] == 0) {
                points.push_back(solid.points[corner]);
                numbers[corner] = static_cast<std::uint32_t>(points.size());
            }
            corner = numbers[corner] - 1;
        }
    solid.points = std::move(points);
    solid.triangles = std::move(triangles);
    for (TriangleMesh::Part& part : solid.parts)
        part.triangleCount = static_cast<std::uint32_t>(solid.triangles.size());
    return dropped;
}

} // namespace bolster
