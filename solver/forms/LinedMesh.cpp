#include "LinedMesh.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace bolster {

namespace {

constexpr double nearPoints = 0.4; // mm: points that lie nearer are one
constexpr double onePlace = 0.02;  // mm: lines that pass so near each other meet
constexpr double crumb = 1;        // mm: sides of a triangle that may go though there are lines around it
constexpr double lowest = 0.01;    // height of a triangle, of its longest edge
constexpr int roundsOfTidying = 6;
constexpr double longestSpur = 14; // mm: what hangs over at the end of a line that was prolonged

/// For CGAL: edges that must not go.
struct HeldEdges {
    const CgalMesh* mesh;
    const CgalMesh::Property_map<FormEdge, bool>* cut;
    FormEdge goes = CgalMesh::null_edge(); ///< is to go, though it may lie at a border
    friend bool get(const HeldEdges& held, FormEdge e)
    {
        return e != held.goes && ((*held.cut)[e] || held.mesh->is_border(e));
    }
};

using Edge = std::pair<int, int>; // the lesser point first

Edge edgeOf(int a, int b)
{
    return {std::min(a, b), std::max(a, b)};
}

std::vector<bool> isOneOf(const std::vector<int>& triangles, std::size_t count)
{
    std::vector<bool> is(count, false);
    for (const int t : triangles)
        is[static_cast<std::size_t>(t)] = true;
    return is;
}

} // namespace

bool LinedMesh::build(const TriangleSoup& soup, std::vector<int> chosen, const std::stop_token& stop)
{
    *this = {};
    m_ends = soup.ends;
    if (chosen.empty())
        for (std::size_t t = 0; t < soup.triangles.size(); ++t)
            chosen.push_back(static_cast<int>(t));
    m_triangles = std::move(chosen);
    const auto faces = static_cast<CgalMesh::size_type>(m_triangles.size());
    mesh.reserve(faces / 2 + faces / 8, faces + faces / 2 + faces / 8, faces); // what an open sheet has, and some
    part = mesh.add_property_map<Face, int>("f:part", 0).first;
    std::vector<int> vertexOf(soup.points.size(), -1);
    for (const int t : m_triangles) {
        std::array<Vertex, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const int p = soup.triangles[static_cast<std::size_t>(t)][k];
            int& vertex = vertexOf[static_cast<std::size_t>(p)];
            if (vertex < 0) {
                vertex = static_cast<int>(m_point.size());
                m_point.push_back(p);
                mesh.add_vertex(toCgal(soup.points[static_cast<std::size_t>(p)]));
            }
            corners[k] = Vertex(static_cast<CgalMesh::size_type>(vertex));
        }
        const Face face = mesh.add_face(corners[0], corners[1], corners[2]);
        if (face == CgalMesh::null_face() || stop.stop_requested()) {
            m_refusedAt = fromCgal(mesh.point(corners[0]));
            return false;
        }
        part[face] = soup.part[static_cast<std::size_t>(t)];
    }
    m_shared.assign(m_point.size(), false);
    if (m_triangles.size() < soup.triangles.size()) {
        const std::vector<bool> mine = isOneOf(m_triangles, soup.triangles.size());
        for (std::size_t t = 0; t < soup.triangles.size(); ++t)
            for (const int p : soup.triangles[t])
                if (const int v = vertexOf[static_cast<std::size_t>(p)]; v >= 0 && !mine[t])
                    m_shared[static_cast<std::size_t>(v)] = true;
    }
    cut = mesh.add_property_map<FormEdge, bool>("e:cut", false).first;
    for (const FormEdge e : mesh.edges())
        cut[e] = !soup.cuts.empty() &&
                 soup.cuts.contains(edgeOf(pointOf(mesh.vertex(e, 0)), pointOf(mesh.vertex(e, 1))));
    return true;
}

void LinedMesh::putBack(TriangleSoup& soup) const
{
    const std::vector<bool> gone = isOneOf(m_triangles, soup.triangles.size());
    for (const int t : m_triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& corners = soup.triangles[static_cast<std::size_t>(t)];
            soup.cuts.erase(edgeOf(corners[k], corners[(k + 1) % 3]));
        }
    std::size_t kept = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        if (!gone[t]) {
            soup.triangles[kept] = soup.triangles[t];
            soup.part[kept++] = soup.part[t];
        }
    soup.triangles.resize(kept);
    soup.part.resize(kept);
    std::vector<int> now = m_point; // and of new vertices
    for (const Vertex v : mesh.vertices())
        if (v.idx() >= now.size()) {
            now.resize(v.idx() + 1, -1);
            now[v.idx()] = static_cast<int>(soup.points.size());
            soup.points.push_back(fromCgal(mesh.point(v)));
        }
    for (const Face f : mesh.faces()) {
        std::array<int, 3> corners{};
        std::size_t k = 0;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
            corners[k++] = now[v.idx()];
        soup.triangles.push_back(corners);
        soup.part.push_back(part[f]);
    }
    for (const FormEdge e : mesh.edges())
        if (cut[e])
            soup.cuts.insert(edgeOf(now[mesh.vertex(e, 0).idx()], now[mesh.vertex(e, 1).idx()]));
}

void LinedMesh::renumberEdges()
{
    std::vector<std::array<Vertex, 3>> faces;
    std::vector<int> parts;
    for (const Face f : mesh.faces()) {
        std::array<Vertex, 3>& corners = faces.emplace_back();
        std::ranges::copy(mesh.vertices_around_face(mesh.halfedge(f)), corners.begin());
        parts.push_back(part[f]);
    }
    std::vector<std::pair<Vertex, Vertex>> cuts;
    for (const FormEdge e : mesh.edges())
        if (cut[e])
            cuts.emplace_back(mesh.vertex(e, 0), mesh.vertex(e, 1));
    CgalMesh anew;
    for (const Vertex v : mesh.vertices())
        anew.add_vertex(mesh.point(v));
    mesh = std::move(anew);
    part = mesh.add_property_map<Face, int>("f:part", 0).first;
    cut = mesh.add_property_map<FormEdge, bool>("e:cut", false).first;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Face face = mesh.add_face(faces[f][0], faces[f][1], faces[f][2]);
        if (face == CgalMesh::null_face())
            throw std::runtime_error("more than two faces at an edge"); // there were not before
        part[face] = parts[f];
    }
    for (const auto& [a, b] : cuts)
        cut[mesh.edge(mesh.halfedge(a, b))] = true;
}

void LinedMesh::tidy()
{
    for (int round = 0; round < roundsOfTidying; ++round) {
        const bool joined = joinNearPoints(), flattened = flattenCaps();
        if (!joined && !flattened)
            return;
    }
}

std::vector<FormEdge> LinedMesh::cutsAt(Vertex v) const
{
    std::vector<FormEdge> cuts;
    for (const auto half : mesh.halfedges_around_target(mesh.halfedge(v)))
        if (const FormEdge e = mesh.edge(half); cut[e] && !mesh.is_border(e))
            cuts.push_back(e);
    return cuts;
}

std::vector<Vertex> LinedMesh::looseEnds(const FormCuts& cuts) const
{
    std::vector<Vertex> ends;
    const auto isKnown = [&](Vertex v) { return v.idx() < m_point.size() && m_ends.contains(pointOf(v)); };
    for (const Vertex v : mesh.vertices())
        if (!mesh.is_isolated(v) && !mesh.is_border(v) && cutsAt(v).size() == 1 && !isCutAnywayAt(v, cuts) &&
            !isKnown(v))
            ends.push_back(v);
    return ends;
}

std::set<int> LinedMesh::loosePoints(const FormCuts& cuts) const
{
    std::set<int> points;
    for (const Vertex v : looseEnds(cuts))
        points.insert(pointOf(v));
    return points;
}

bool LinedMesh::isCutAnyway(FormEdge edge, const FormCuts& cuts) const
{
    if (mesh.is_border(edge) || cut[edge])
        return true;
    const auto half = mesh.halfedge(edge), other = mesh.opposite(half);
    if (cuts.groups && part[mesh.face(half)] != part[mesh.face(other)])
        return true;
    return cuts.angle &&
           normalBeside(half).dot(normalBeside(other)) < std::cos(*cuts.angle * std::numbers::pi / 180);
}

/// Of edges that no line has cut.
bool LinedMesh::isCutAnywayAt(Vertex v, const FormCuts& cuts) const
{
    const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
    return std::ranges::any_of(around, [&](auto half) {
        const FormEdge e = mesh.edge(half);
        return !cut[e] && isCutAnyway(e, cuts);
    });
}

Vec3 LinedMesh::normalBeside(CgalMesh::Halfedge_index half) const
{
    const Vec3 from = fromCgal(mesh.point(mesh.source(half)));
    const Vec3 to = fromCgal(mesh.point(mesh.target(half)));
    const Vec3 third = fromCgal(mesh.point(mesh.target(mesh.next(half))));
    return (to - from).cross(third - from).normalized();
}

std::pair<Vec3, Vec3> LinedMesh::endsOf(FormEdge e) const
{
    return {fromCgal(mesh.point(mesh.vertex(e, 0))), fromCgal(mesh.point(mesh.vertex(e, 1)))};
}

double LinedMesh::lengthOf(FormEdge e) const
{
    return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

/// Of a triangle, over its longest edge and against its length: whether it is as good as that edge. Long triangles
/// beside a line may be low, and have their width nevertheless.
bool LinedMesh::isCap(Vertex a, Vertex b, Vertex c) const
{
    const double longest = std::max({(fromCgal(mesh.point(b)) - fromCgal(mesh.point(a))).norm(),
                                     (fromCgal(mesh.point(c)) - fromCgal(mesh.point(b))).norm(),
                                     (fromCgal(mesh.point(a)) - fromCgal(mesh.point(c))).norm()});
    const double height = heightOf(a, b, c);
    return height <= lowest && height * longest <= nearPoints;
}

/// Over its longest edge and against its length.
double LinedMesh::heightOf(Vertex a, Vertex b, Vertex c) const
{
    const Vec3 x = fromCgal(mesh.point(a)), y = fromCgal(mesh.point(b)), z = fromCgal(mesh.point(c));
    const double longest = std::max({(y - x).squaredNorm(), (z - y).squaredNorm(), (x - z).squaredNorm(), 1e-12});
    return (y - x).cross(z - x).norm() / longest;
}

bool LinedMesh::isHeld(FormEdge e) const
{
    return get(HeldEdges{&mesh, &cut}, e);
}

bool LinedMesh::isOnLine(Vertex v) const
{
    const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
    return std::ranges::any_of(around, [&](auto half) { return cut[mesh.edge(half)]; });
}

/// Of a triangle, whose other two edges become one when this one goes.
bool LinedMesh::bothHeldBeside(CgalMesh::Halfedge_index half) const
{
    return !mesh.is_border(half) && isHeld(mesh.edge(mesh.next(half))) && isHeld(mesh.edge(mesh.prev(half)));
}

/// The one of these that is no border, and may give way to the other; none where both are.
std::optional<FormEdge> LinedMesh::lineBeside(CgalMesh::Halfedge_index half) const
{
    for (const auto other : {mesh.next(half), mesh.prev(half)})
        if (const FormEdge e = mesh.edge(other); !mesh.is_border(e))
            return e;
    return std::nullopt;
}

/// A triangle between an edge that is to go and two lines, which become one then: it is no piece.
bool LinedMesh::isCrumb(CgalMesh::Halfedge_index half) const
{
    return lengthOf(mesh.edge(half)) < onePlace ||
           std::max(lengthOf(mesh.edge(mesh.next(half))), lengthOf(mesh.edge(mesh.prev(half)))) < crumb;
}

/// Of those edges of two triangles beside an edge that become one, one at most is held; two lines beside a splinter
/// become one.
bool LinedMesh::canCollapse(FormEdge e) const
{
    const Vertex a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
    if (isShared(a) || isShared(b) || !CGAL::Euler::does_satisfy_link_condition(e, mesh))
        return false;
    for (const auto half : {mesh.halfedge(e, 0), mesh.halfedge(e, 1)})
        if (bothHeldBeside(half) && (!isCrumb(half) || !lineBeside(half)))
            return false;
    const bool bothHeld = (isOnLine(a) || mesh.is_border(a)) && (isOnLine(b) || mesh.is_border(b));
    return isHeld(e) || !bothHeld || lengthOf(e) < onePlace;
}

/// A line that passes close by a point goes through it. Whether there were such.
bool LinedMesh::joinNearPoints()
{
    std::vector<FormEdge> edges;
    for (const FormEdge e : mesh.edges())
        if (lengthOf(e) < nearPoints)
            edges.push_back(e);
    bool any = false;
    for (const FormEdge e : edges) {
        if (mesh.is_removed(e) || lengthOf(e) >= nearPoints || !canCollapse(e))
            continue;
        const Vertex a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
        // Borders stay where they are, then places where lines meet, then lines.
        const auto rank = [&](Vertex v) {
            return mesh.is_border(v) ? std::numeric_limits<std::size_t>::max() : cutsAt(v).size();
        };
        const Kernel::Point_3 at = mesh.point(rank(a) > rank(b) ? a : b);
        cut[e] = false;
        for (const auto half : {mesh.halfedge(e, 0), mesh.halfedge(e, 1)})
            if (bothHeldBeside(half))
                cut[*lineBeside(half)] = false;
        mesh.point(CGAL::Euler::collapse_edge(e, mesh, HeldEdges{&mesh, &cut, e})) = at;
        any = true;
    }
    return any;
}

/// Triangles that are as good as their longest edge: another edge takes its place, or the line goes the other
/// way around. Whether there were such.
bool LinedMesh::flattenCaps()
{
    bool any = false;
    for (const Face f : mesh.faces()) {
        auto longest = mesh.halfedge(f);
        for (auto half : mesh.halfedges_around_face(mesh.halfedge(f)))
            if (lengthOf(mesh.edge(half)) > lengthOf(mesh.edge(longest)))
                longest = half;
        const FormEdge e = mesh.edge(longest);
        const auto other = mesh.opposite(longest);
        const Vertex a = mesh.source(longest), b = mesh.target(longest), c1 = mesh.target(mesh.next(longest));
        const double height = heightOf(a, b, c1);
        if (!isCap(a, b, c1) || mesh.is_border(e))
            continue;
        const Vertex c2 = mesh.target(mesh.next(other));
        // Beside a triangle of its kind it waits until that one has found a better neighbour.
        if (std::min(heightOf(c1, c2, a), heightOf(c1, c2, b)) <= height ||
            mesh.halfedge(c1, c2) != CgalMesh::null_halfedge() || (isShared(c1) && isShared(c2)))
            continue;
        if (cut[e]) {
            cut[e] = false;
            cut[mesh.edge(mesh.next(longest))] = cut[mesh.edge(mesh.prev(longest))] = true;
        }
        const Face low = mesh.face(longest), beside = mesh.face(other);
        CGAL::Euler::flip_edge(longest, mesh);
        part[low] = part[beside]; // both are halves of the neighbour now
        any = true;
    }
    return any;
}

void LinedMesh::pruneSpurs(const FormCuts& cuts)
{
    for (const FormEdge e : mesh.edges())
        if (mesh.is_border(e))
            cut[e] = false;
    for (Vertex end : looseEnds(cuts)) {
        std::vector<FormEdge> spur;
        double length = 0;
        for (Vertex at = end; length <= longestSpur;) {
            std::vector<FormEdge> goesOn = cutsAt(at);
            std::erase_if(goesOn, [&](FormEdge e) { return std::ranges::find(spur, e) != spur.end(); });
            if (goesOn.size() != 1 || (at != end && (mesh.is_border(at) || isCutAnywayAt(at, cuts))))
                break;
            spur.push_back(goesOn.front());
            length += lengthOf(goesOn.front());
            at = mesh.vertex(goesOn.front(), mesh.vertex(goesOn.front(), 0) == at ? 1 : 0);
        }
        if (length <= longestSpur)
            for (const FormEdge e : spur)
                cut[e] = false;
    }
}

} // namespace bolster
