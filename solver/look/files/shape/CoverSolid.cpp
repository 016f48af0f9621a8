#include "CoverSolid.h"

#include "HalfEdges.h"
#include "UnionFind.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr double hair = 0.01; ///< mm between sheets: at one place, an edge would have four triangles

/// The sewn cover as sheets: each edge has one or two triangles, each point one fan of them.
struct Sheets {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    std::vector<std::array<std::uint32_t, 2>> borders; ///< edges as their only triangle has them
    std::vector<std::uint32_t> origin;                 ///< of each point: the sewn vertex
};

std::vector<Triangle> sewnTriangles(const CoverTopology& topology)
{
    std::vector<Triangle> sewn;
    for (const Triangle& t : topology.triangles) {
        const Triangle s{topology.merged[t[0]], topology.merged[t[1]], topology.merged[t[2]]};
        if (s[0] != s[1] && s[1] != s[2] && s[2] != s[0])
            sewn.push_back(s);
    }
    return sewn;
}

int cornerOf(const HalfEdge& half, bool end)
{
    return 3 * half.triangle + (half.side + (end ? 1 : 0)) % 3;
}

/// Joins the corners of triangles across edges that two of them share; the others are borders.
Sheets sheetsOf(const std::vector<Triangle>& sewn, const std::vector<Vec3>& places)
{
    UnionFind corners(static_cast<int>(3 * sewn.size()));
    std::vector<HalfEdge> open;
    eachEdge(halfEdges(sewn), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first != 2 || first[0].forward == first[1].forward || first[0].triangle == first[1].triangle) {
            open.insert(open.end(), first, last);
            return;
        }
        corners.join(cornerOf(first[0], false), cornerOf(first[1], true));
        corners.join(cornerOf(first[0], true), cornerOf(first[1], false));
    });
    Sheets sheets;
    std::vector<std::uint32_t> ofCorner;
    const std::vector<int> labels = corners.labels(); // counted as they come
    for (std::size_t c = 0; c < labels.size(); ++c) {
        ofCorner.push_back(static_cast<std::uint32_t>(labels[c]));
        if (ofCorner.back() == sheets.points.size()) {
            sheets.origin.push_back(sewn[c / 3][c % 3]);
            sheets.points.push_back(places[sheets.origin.back()]);
        }
    }
    for (std::size_t t = 0; t < sewn.size(); ++t)
        sheets.triangles.push_back({ofCorner[3 * t], ofCorner[3 * t + 1], ofCorner[3 * t + 2]});
    for (const HalfEdge& half : open)
        sheets.borders.push_back({ofCorner[static_cast<std::size_t>(cornerOf(half, false))],
                                  ofCorner[static_cast<std::size_t>(cornerOf(half, true))]});
    return sheets;
}

/// Sheets that meet are drawn back from each other.
void partSheets(Sheets& sheets)
{
    std::map<std::uint32_t, int> copies;
    for (const std::uint32_t vertex : sheets.origin)
        ++copies[vertex];
    std::vector<Vec3> around(sheets.points.size(), Vec3::Zero());
    for (const Triangle& t : sheets.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            around[t[i]] += sheets.points[t[(i + 1) % 3]] + sheets.points[t[(i + 2) % 3]] - 2 * sheets.points[t[i]];
    std::map<std::uint32_t, int> seen;
    for (std::size_t p = 0; p < sheets.points.size(); ++p) {
        if (copies[sheets.origin[p]] < 2)
            continue;
        const int turn = ++seen[sheets.origin[p]]; // two that are drawn the same way are parted, too
        if (around[p].norm() > 0)
            sheets.points[p] += (1 + 0.25 * turn) * hair * around[p].normalized();
    }
}

/// Where the inside is, from each point: across the triangles around it, farther where these bend.
std::vector<Vec3> downwards(const Sheets& sheets, double thickness)
{
    constexpr double farthest = 2; // of the thickness, at a sharp edge
    std::vector<Vec3> sums(sheets.points.size(), Vec3::Zero());
    std::vector<Vec3> normals;
    for (const Triangle& t : sheets.triangles) {
        const Vec3 &a = sheets.points[t[0]], &b = sheets.points[t[1]], &c = sheets.points[t[2]];
        const Vec3 normal = (b - a).cross(c - a);
        normals.push_back(normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::Zero()));
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 u = sheets.points[t[(i + 1) % 3]] - sheets.points[t[i]];
            const Vec3 v = sheets.points[t[(i + 2) % 3]] - sheets.points[t[i]];
            sums[t[i]] += std::atan2(u.cross(v).norm(), u.dot(v)) * normals.back();
        }
    }
    std::vector<double> least(sheets.points.size(), 1);
    for (Vec3& sum : sums)
        sum = sum.norm() > 1e-9 ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
        for (const std::uint32_t p : sheets.triangles[t])
            if (normals[t].squaredNorm() > 0)
                least[p] = std::min(least[p], normals[t].dot(sums[p]));
    for (std::size_t p = 0; p < sums.size(); ++p)
        sums[p] *= -thickness * std::min(farthest, 1 / std::max(least[p], 1e-3));
    return sums;
}

} // namespace

TriangleMesh coverSolid(const CoverMesh& cover, double thickness)
{
    const CoverTopology& topology = *cover.topology;
    std::vector<Vec3> places;
    for (std::size_t v = 0; v < topology.merged.size(); ++v) {
        places.resize(std::max<std::size_t>(places.size(), topology.merged[v] + 1), Vec3::Zero());
        places[topology.merged[v]] = cover.points[v].cast<double>();
    }
    Sheets sheets = sheetsOf(sewnTriangles(topology), places);
    partSheets(sheets);
    const std::vector<Vec3> down = downwards(sheets, thickness);
    const auto count = static_cast<std::uint32_t>(sheets.points.size());
    TriangleMesh solid;
    solid.points = sheets.points;
    for (std::uint32_t p = 0; p < count; ++p)
        solid.points.emplace_back(sheets.points[p] + down[p]);
    solid.triangles = sheets.triangles;
    for (const Triangle& t : sheets.triangles)
        solid.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
    for (const auto& [a, b] : sheets.borders) {
        solid.triangles.push_back({b, a, a + count});
        solid.triangles.push_back({b, a + count, b + count});
    }
    solid.parts = {{"cover", 0, static_cast<std::uint32_t>(solid.triangles.size())}};
    return solid;
}

double enclosedVolume(const TriangleMesh& mesh)
{
    if (mesh.points.empty())
        return 0;
    const Vec3 origin = mesh.points.front();
    double six = 0;
    for (const auto& t : mesh.triangles)
        six += (mesh.points[t[0]] - origin).dot((mesh.points[t[1]] - origin).cross(mesh.points[t[2]] - origin));
    return six / 6;
}

} // namespace bolster
