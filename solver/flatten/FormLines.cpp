#include "FormLines.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

namespace bolster {

namespace {

namespace Pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = CgalMesh::Vertex_index;
using FormEdge = CgalMesh::Edge_index;
using Face = CgalMesh::Face_index;
using FaceTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<CgalMesh>>>;

constexpr double spacing = 4, draftSpacing = 12; // mm between places on a line
constexpr double ribbon = 1.5;                   // mm that a ribbon stands out on either side
constexpr double shortest = 1, longest = 1e5;    // mm, of a line
constexpr double farthest = 25;                  // mm: what lies farther from the form is no line on it
constexpr double reach = 10;       // mm: a line that ends so near to a border or another line goes on to it
constexpr double overshoot = 1;    // mm, so that they surely cross
constexpr double nearPoints = 0.4; // mm: points that lie nearer are one
constexpr double lowest = 0.01;    // height of a triangle, of its longest edge
constexpr int roundsOfTidying = 6;
constexpr double longestSpur = 14; // mm: what hangs over at the end of a line that was prolonged

Kernel::Point_3 toCgal(const Vec3& p)
{
    return {p.x(), p.y(), p.z()};
}

Vec3 fromCgal(const Kernel::Point_3& p)
{
    return {p.x(), p.y(), p.z()};
}

/// Which part the triangles belong to that others are divided into.
struct PartsKept : Pmp::Corefinement::Default_visitor<CgalMesh> {
    CgalMesh::Property_map<Face, int> part;
    const CgalMesh* form = nullptr;
    const std::stop_token* stop = nullptr;
    int divided = 0;

    void triangulating_faces_step() const
    {
        if (stop->stop_requested())
            throw std::runtime_error("stopped");
    }
    void before_subface_creations(Face face, CgalMesh& mesh)
    {
        if (&mesh == form)
            divided = part[face];
    }
    void after_subface_created(Face face, CgalMesh& mesh)
    {
        if (&mesh == form)
            part[face] = divided;
    }
};

/// A place of a line on the form.
struct LinePlace {
    Vec3 at, normal;
    double away = 0; ///< mm from the form
};

std::vector<Vec3> evenly(const FormLine& line, double spacing)
{
    std::vector<Vec3> places{line.points.front()};
    std::vector<Vec3> corners = line.points;
    if (line.closed)
        corners.push_back(corners.front());
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const Vec3 from = corners[k - 1], way = corners[k] - from;
        const int steps = static_cast<int>(std::ceil(way.norm() / spacing)); // none where two points are one
        for (int i = 1; i <= steps; ++i)
            places.emplace_back(from + way * i / steps);
    }
    return places;
}

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

/// Triangles that a ribbon may meet. It meets no edge between one of them and another one.
std::vector<int> trianglesNear(const TriangleSoup& soup, const CgalMesh& strip)
{
    std::vector<Box3> boxes;
    Box3 all;
    for (const Face f : strip.faces()) {
        boxes.emplace_back();
        for (const Vertex v : strip.vertices_around_face(strip.halfedge(f)))
            boxes.back().extend(fromCgal(strip.point(v)));
        all.extend(boxes.back());
    }
    std::vector<int> found;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        Box3 box;
        for (const int corner : soup.triangles[t])
            box.extend(soup.points[static_cast<std::size_t>(corner)]);
        if (all.intersects(box) && std::ranges::any_of(boxes, [&](const Box3& b) { return b.intersects(box); }))
            found.push_back(static_cast<int>(t));
    }
    return found;
}

/// Triangles of the form as CGAL has them.
struct Piece {
    CgalMesh mesh;
    CgalMesh::Property_map<Face, int> part;
    CgalMesh::Property_map<FormEdge, bool> cut;
    std::vector<int> triangles; ///< of the soup
    std::vector<int> point;     ///< of each vertex that it had from the beginning

    /// Of these triangles; none: of all. False where an edge has three of them, or two sheets meet in a point.
    bool build(const TriangleSoup& soup, std::vector<int> chosen)
    {
        *this = {};
        if (chosen.empty())
            for (std::size_t t = 0; t < soup.triangles.size(); ++t)
                chosen.push_back(static_cast<int>(t));
        triangles = std::move(chosen);
        part = mesh.add_property_map<Face, int>("f:part", 0).first;
        std::vector<int> vertexOf(soup.points.size(), -1);
        for (const int t : triangles) {
            std::array<Vertex, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const int p = soup.triangles[static_cast<std::size_t>(t)][k];
                int& vertex = vertexOf[static_cast<std::size_t>(p)];
                if (vertex < 0) {
                    vertex = static_cast<int>(point.size());
                    point.push_back(p);
                    mesh.add_vertex(toCgal(soup.points[static_cast<std::size_t>(p)]));
                }
                corners[k] = Vertex(static_cast<CgalMesh::size_type>(vertex));
            }
            const Face face = mesh.add_face(corners[0], corners[1], corners[2]);
            if (face == CgalMesh::null_face())
                return false;
            part[face] = soup.part[static_cast<std::size_t>(t)];
        }
        cut = mesh.add_property_map<FormEdge, bool>("e:cut", false).first;
        for (const FormEdge e : mesh.edges())
            cut[e] = !soup.cuts.empty() &&
                     soup.cuts.contains(edgeOf(pointOf(mesh.vertex(e, 0)), pointOf(mesh.vertex(e, 1))));
        return true;
    }

    /// In place of the triangles that it was made of.
    void putBack(TriangleSoup& soup)
    {
        std::set<int> gone(triangles.begin(), triangles.end());
        for (const int t : triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& corners = soup.triangles[static_cast<std::size_t>(t)];
                soup.cuts.erase(edgeOf(corners[k], corners[(k + 1) % 3]));
            }
        std::size_t kept = 0;
        for (std::size_t t = 0; t < soup.triangles.size(); ++t)
            if (!gone.contains(static_cast<int>(t))) {
                soup.triangles[kept] = soup.triangles[t];
                soup.part[kept++] = soup.part[t];
            }
        soup.triangles.resize(kept);
        soup.part.resize(kept);
        std::vector<int> now = point; // and of new vertices
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

private:
    int pointOf(Vertex v) const { return point[v.idx()]; }
};

class LineCutter {
public:
    LineCutter(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
               const std::vector<int>& part, double apart)
        : m_soup{points, triangles, part, {}}
        , m_spacing(apart)
        , m_whole(m_form.build(m_soup, {}))
    {
        if (m_whole)
            m_tree.rebuild(m_form.mesh.faces().begin(), m_form.mesh.faces().end(), m_form.mesh);
    }

    bool whole() const { return m_whole; }
    const TriangleSoup& soup() const { return m_soup; }
    const std::vector<Message>& notes() const { return m_notes; }
    /// As it was when some lines had been cut.
    void goOnFrom(const TriangleSoup& soup, const std::vector<Message>& notes)
    {
        m_soup = soup;
        m_notes = notes;
    }

    void cut(const FormLine& line, const std::vector<FormLine>& all, const std::stop_token& stop)
    {
        double length = 0;
        for (std::size_t k = 1; k < line.points.size(); ++k)
            length += (line.points[k] - line.points[k - 1]).norm();
        if (!(length > shortest && length < longest)) {
            m_notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "%1 has no length: it is not cut along it"), {line.name}});
            return;
        }
        if (const double away = distanceOf(line); away > farthest) {
            m_notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "%1 is %2 mm away from the form: it is not cut along it"),
                 {line.name, numberText(away, 2)}});
            return;
        }
        const std::vector<FormLine> parts = awayFromBorder(line);
        if (parts.empty())
            m_notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "%1 runs along the border of the form: there is nothing "
                                              "to cut"),
                 {line.name}});
        for (const FormLine& part : parts)
            cutNow(part, all, stop);
    }

    LinedTriangles result(const std::vector<FormLine>& lines)
    {
        m_tree.clear(); // of the form as it was
        m_form.build(m_soup, {});
        pruneSpurs();
        for (int round = 0; round < roundsOfTidying && (joinNearPoints() || flattenCaps()); ++round)
            m_form.mesh.collect_garbage();
        LinedTriangles result;
        result.notes = m_notes;
        std::map<Vertex, int> number;
        for (const Vertex v : m_form.mesh.vertices()) {
            number[v] = static_cast<int>(result.points.size());
            result.points.push_back(fromCgal(m_form.mesh.point(v)));
        }
        for (const Face f : m_form.mesh.faces()) {
            std::array<int, 3> corners{};
            int k = 0;
            for (const Vertex v : m_form.mesh.vertices_around_face(m_form.mesh.halfedge(f)))
                corners[static_cast<std::size_t>(k++)] = number[v];
            result.triangles.push_back(corners);
            result.part.push_back(m_form.part[f]);
        }
        for (const FormEdge e : m_form.mesh.edges())
            if (m_form.cut[e]) {
                const int a = number[m_form.mesh.vertex(e, 0)], b = number[m_form.mesh.vertex(e, 1)];
                result.cuts.insert({std::min(a, b), std::max(a, b)});
            }
        for (const Vertex v : looseEnds())
            result.notes.push_back(looseEnd(fromCgal(m_form.mesh.point(v)), lines));
        return result;
    }

private:
    void cutNow(const FormLine& line, const std::vector<FormLine>& all, const std::stop_token& stop)
    {
        CgalMesh strip = ribbonAlong(line, all);
        Piece near;
        // Where sheets touch in a point when they are taken alone, all of it is.
        if (!near.build(m_soup, trianglesNear(m_soup, strip)))
            near.build(m_soup, {});
        PartsKept visitor;
        visitor.part = near.part;
        visitor.form = &near.mesh;
        visitor.stop = &stop;
        try { // where one of them goes through itself; else it might come to no end
            Pmp::corefine(
                near.mesh, strip,
                CGAL::parameters::edge_is_constrained_map(near.cut).visitor(visitor).throw_on_self_intersection(
                    true));
        } catch (const Pmp::Corefinement::Self_intersection_exception&) {
            m_notes.push_back({QT_TRANSLATE_NOOP("Message", "%1 bends too sharply there, or the form goes through "
                                                            "itself: it is not cut along it"),
                               {line.name}});
            return;
        }
        near.putBack(m_soup);
    }

    /// Of most of its places, mm.
    double distanceOf(const FormLine& line) const
    {
        std::vector<double> distances;
        for (const Vec3& place : line.points)
            distances.push_back(std::sqrt(m_tree.squared_distance(toCgal(place))));
        std::ranges::sort(distances);
        return distances[distances.size() / 2];
    }

    LinePlace placeOf(const Vec3& at) const
    {
        const auto [point, face] = m_tree.closest_point_and_primitive(toCgal(at));
        std::array<Vec3, 3> corners;
        std::size_t k = 0;
        for (const Vertex v : m_form.mesh.vertices_around_face(m_form.mesh.halfedge(face)))
            corners[k++] = fromCgal(m_form.mesh.point(v));
        const Vec3 near = fromCgal(point);
        return {near, (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized(), (at - near).norm()};
    }

    /// Whether a place lies beside the form, outside of its border.
    bool isBeyond(const Vec3& at) const
    {
        constexpr double beside = 0.05, same = 1e-6; // mm
        const auto [near, face] = m_tree.closest_point_and_primitive(toCgal(at));
        if ((fromCgal(near) - at).norm() < beside)
            return false;
        for (const auto half : m_form.mesh.halfedges_around_face(m_form.mesh.halfedge(face))) {
            const Kernel::Point_3 &a = m_form.mesh.point(m_form.mesh.source(half)),
                                  &b = m_form.mesh.point(m_form.mesh.target(half));
            const bool isAtCorner =
                m_form.mesh.is_border(m_form.mesh.target(half)) && CGAL::squared_distance(near, b) < same * same;
            const bool isOnEdge = m_form.mesh.is_border(m_form.mesh.edge(half)) &&
                                  CGAL::squared_distance(near, Kernel::Segment_3(a, b)) < same * same;
            if (isAtCorner || isOnEdge)
                return true;
        }
        return false;
    }

    /// The place of a border that is nearest to a place on the form; none where no border is near.
    std::optional<Vec3> borderNear(const Vec3& at) const
    {
        const auto [near, face] = m_tree.closest_point_and_primitive(toCgal(at));
        std::optional<Vec3> found;
        for (const Vertex v : m_form.mesh.vertices_around_face(m_form.mesh.halfedge(face)))
            for (const auto half : m_form.mesh.halfedges_around_target(m_form.mesh.halfedge(v))) {
                if (!m_form.mesh.is_border(m_form.mesh.edge(half)))
                    continue;
                const Vec3 from = fromCgal(m_form.mesh.point(m_form.mesh.source(half)));
                const Vec3 way = fromCgal(m_form.mesh.point(m_form.mesh.target(half))) - from;
                const double share = way.squaredNorm() > 0 ? (at - from).dot(way) / way.squaredNorm() : 0;
                const Vec3 place = from + std::clamp(share, 0.0, 1.0) * way;
                if (!found || (place - at).norm() < (*found - at).norm())
                    found = place;
            }
        return found;
    }

    double distanceFromBorder(const Vec3& at) const
    {
        const std::optional<Vec3> border = borderNear(at);
        return border ? (*border - at).norm() : std::numeric_limits<double>::infinity();
    }

    /// Where a line that comes from along the border leaves it: straight across, a little outside.
    Vec3 acrossBorder(const Vec3& at) const
    {
        const Vec3 border = borderNear(at).value_or(at), way = border - at;
        return way.norm() > 0 ? Vec3(border + overshoot * way.normalized()) : border;
    }

    /// The parts of a line between those that run along a border, which cut nothing; the line itself where it only
    /// ends there.
    std::vector<FormLine> awayFromBorder(const FormLine& line) const
    {
        constexpr double on = 1, away = 3; // mm
        std::vector<Vec3> places = evenly(line, m_spacing);
        std::vector<double> distances;
        for (const Vec3& place : places)
            distances.push_back(distanceFromBorder(place));
        const auto isOn = [&](double distance) { return distance < on; };
        if (line.closed) {
            const auto first = std::ranges::find_if(distances, isOn);
            if (first == distances.end())
                return {line};
            places.pop_back(); // the first one again
            distances.pop_back();
            const auto turn = first - distances.begin();
            std::rotate(places.begin(), places.begin() + turn, places.end());
            std::rotate(distances.begin(), distances.begin() + turn, distances.end());
            places.push_back(places.front());
            distances.push_back(distances.front());
        }
        std::vector<FormLine> parts;
        for (auto begin = distances.begin(); begin != distances.end();) {
            begin = std::find_if_not(begin, distances.end(), isOn);
            const auto end = std::find_if(begin, distances.end(), isOn);
            const auto from = begin - distances.begin(), to = end - distances.begin();
            bool cuts = false;
            for (auto k = from; k < to; ++k)
                cuts = cuts || (distances[k] > away && !isBeyond(places[k]));
            if (cuts) {
                const bool comes = from > 0, goes = to < std::ssize(places);
                if (from <= 1 && to + 1 >= std::ssize(places) && !line.closed)
                    return {line};
                FormLine part = line;
                part.closed = false;
                part.points.assign(places.begin() + from, places.begin() + to);
                if (comes)
                    part.points.insert(part.points.begin(), acrossBorder(places[from]));
                if (goes)
                    part.points.push_back(acrossBorder(places[to - 1]));
                parts.push_back(std::move(part));
            }
            begin = end;
        }
        return parts;
    }

    /// What runs on outside would be pulled back to the border, and cut along it. One place stays outside at each
    /// end that goes there; whether they do.
    std::pair<bool, bool> trim(std::vector<Vec3>& places, const FormLine& line) const
    {
        if (line.closed)
            return {false, false};
        const auto isInside = [&](const Vec3& at) { return !isBeyond(at); };
        const auto first = std::ranges::find_if(places, isInside);
        if (first == places.end())
            return {false, false};
        const auto last = std::find_if(places.rbegin(), places.rend(), isInside).base(); // behind the last one
        const bool starts = first != places.begin(), ends = last != places.end();
        places = std::vector<Vec3>(first - static_cast<int>(starts), last + static_cast<int>(ends));
        return {starts, ends};
    }

    /// On to a border or another line that is near, where it is not outside of the border.
    void prolong(std::vector<Vec3>& places, const FormLine& line, const std::vector<FormLine>& all) const
    {
        const auto [starts, ends] = trim(places, line);
        if (line.closed || places.size() < 2)
            return;
        const auto missing = [&](const Vec3& end) {
            double nearest = reach;
            for (const auto half : m_form.mesh.halfedges())
                if (m_form.mesh.is_border(half))
                    nearest =
                        std::min(nearest, (fromCgal(m_form.mesh.point(m_form.mesh.target(half))) - end).norm());
            for (const FormLine& other : all)
                if (!(other == line))
                    for (const Vec3& place : evenly(other, spacing))
                        nearest = std::min(nearest, (place - end).norm());
            return nearest < reach ? nearest + overshoot : overshoot;
        };
        const Vec3 first = places.front() - places[1], last = places.back() - places[places.size() - 2];
        if (!starts)
            places.insert(places.begin(), places.front() + missing(places.front()) * first.normalized());
        if (!ends)
            places.push_back(places.back() + missing(places.back()) * last.normalized());
    }

    CgalMesh ribbonAlong(const FormLine& line, const std::vector<FormLine>& all) const
    {
        std::vector<Vec3> places = evenly(line, m_spacing);
        prolong(places, line, all);
        std::vector<LinePlace> on;
        for (const Vec3& place : places)
            on.push_back(placeOf(place));
        CgalMesh strip;
        std::vector<std::pair<Vertex, Vertex>> sections;
        for (std::size_t k = 0; k < on.size(); ++k) {
            Vec3 normal = Vec3::Zero(); // of neighbours too: at an edge of the form it turns
            for (std::size_t i = k > 0 ? k - 1 : 0; i <= std::min(k + 1, on.size() - 1); ++i)
                normal += on[i].normal;
            normal.normalize();
            // What was prolonged beyond the border stays there: it is not pulled back to it.
            const bool beyond = (k == 0 || k + 1 == on.size()) && !line.closed;
            const Vec3 middle = beyond ? places[k] : on[k].at;
            const double width = ribbon + (beyond ? on[k].away : 0);
            sections.emplace_back(strip.add_vertex(toCgal(middle - width * normal)),
                                  strip.add_vertex(toCgal(middle + width * normal)));
        }
        if (line.closed)
            sections.back() = sections.front();
        for (std::size_t k = 1; k < sections.size(); ++k) {
            const auto& [a, b] = sections[k - 1];
            const auto& [c, d] = sections[k];
            strip.add_face(a, c, b);
            strip.add_face(b, c, d);
        }
        return strip;
    }

    std::vector<FormEdge> cutsAt(Vertex v) const
    {
        std::vector<FormEdge> cuts;
        for (const auto half : m_form.mesh.halfedges_around_target(m_form.mesh.halfedge(v)))
            if (const FormEdge e = m_form.mesh.edge(half); m_form.cut[e] && !m_form.mesh.is_border(e))
                cuts.push_back(e);
        return cuts;
    }

    std::vector<Vertex> looseEnds() const
    {
        std::vector<Vertex> ends;
        for (const Vertex v : m_form.mesh.vertices())
            if (!m_form.mesh.is_isolated(v) && !m_form.mesh.is_border(v) && cutsAt(v).size() == 1)
                ends.push_back(v);
        return ends;
    }

    double lengthOf(FormEdge e) const
    {
        return std::sqrt(CGAL::squared_distance(m_form.mesh.point(m_form.mesh.vertex(e, 0)),
                                                m_form.mesh.point(m_form.mesh.vertex(e, 1))));
    }
    bool isHeld(FormEdge e) const { return get(HeldEdges{&m_form.mesh, &m_form.cut}, e); }
    bool isOnLine(Vertex v) const
    {
        const auto around = m_form.mesh.halfedges_around_target(m_form.mesh.halfedge(v));
        return std::ranges::any_of(around, [&](auto half) { return m_form.cut[m_form.mesh.edge(half)]; });
    }

    /// Of those edges of two triangles beside an edge that become one, one at most is held.
    bool canCollapse(FormEdge e) const
    {
        if (!CGAL::Euler::does_satisfy_link_condition(e, m_form.mesh))
            return false;
        for (const auto half : {m_form.mesh.halfedge(e, 0), m_form.mesh.halfedge(e, 1)})
            if (!m_form.mesh.is_border(half) && isHeld(m_form.mesh.edge(m_form.mesh.next(half))) &&
                isHeld(m_form.mesh.edge(m_form.mesh.prev(half))))
                return false;
        const Vertex a = m_form.mesh.vertex(e, 0), b = m_form.mesh.vertex(e, 1);
        const bool bothHeld =
            (isOnLine(a) || m_form.mesh.is_border(a)) && (isOnLine(b) || m_form.mesh.is_border(b));
        return isHeld(e) || !bothHeld;
    }

    /// A line that passes close by a point goes through it. Whether there were such.
    bool joinNearPoints()
    {
        std::vector<FormEdge> edges;
        for (const FormEdge e : m_form.mesh.edges())
            if (lengthOf(e) < nearPoints)
                edges.push_back(e);
        bool any = false;
        for (const FormEdge e : edges) {
            if (m_form.mesh.is_removed(e) || lengthOf(e) >= nearPoints || !canCollapse(e))
                continue;
            const Vertex a = m_form.mesh.vertex(e, 0), b = m_form.mesh.vertex(e, 1);
            // Borders stay where they are, and lines where nothing else is.
            const auto rank = [&](Vertex v) { return m_form.mesh.is_border(v) ? 2 : isOnLine(v) ? 1 : 0; };
            const Kernel::Point_3 at = m_form.mesh.point(rank(a) > rank(b) ? a : b);
            m_form.cut[e] = false;
            m_form.mesh.point(CGAL::Euler::collapse_edge(e, m_form.mesh, HeldEdges{&m_form.mesh, &m_form.cut, e})) =
                at;
            any = true;
        }
        return any;
    }

    /// Triangles that are as good as their longest edge: another edge takes its place, or the line goes the other
    /// way around. Whether there were such.
    bool flattenCaps()
    {
        bool any = false;
        for (const Face f : m_form.mesh.faces()) {
            auto longest = m_form.mesh.halfedge(f);
            for (auto half : m_form.mesh.halfedges_around_face(m_form.mesh.halfedge(f)))
                if (lengthOf(m_form.mesh.edge(half)) > lengthOf(m_form.mesh.edge(longest)))
                    longest = half;
            const FormEdge e = m_form.mesh.edge(longest);
            const Vec3 a = fromCgal(m_form.mesh.point(m_form.mesh.source(longest)));
            const Vec3 b = fromCgal(m_form.mesh.point(m_form.mesh.target(longest)));
            const Vec3 c = fromCgal(m_form.mesh.point(m_form.mesh.target(m_form.mesh.next(longest))));
            if ((b - a).cross(c - a).norm() > lowest * (b - a).squaredNorm() || m_form.mesh.is_border(e))
                continue;
            const auto other = m_form.mesh.opposite(longest);
            const Vertex c1 = m_form.mesh.target(m_form.mesh.next(longest)),
                         c2 = m_form.mesh.target(m_form.mesh.next(other));
            if (m_form.mesh.halfedge(c1, c2) != CgalMesh::null_halfedge())
                continue;
            if (m_form.cut[e]) {
                m_form.cut[e] = false;
                m_form.cut[m_form.mesh.edge(m_form.mesh.next(longest))] =
                    m_form.cut[m_form.mesh.edge(m_form.mesh.prev(longest))] = true;
            }
            CGAL::Euler::flip_edge(longest, m_form.mesh);
            any = true;
        }
        return any;
    }

    /// What hangs over where a line has met another one.
    void pruneSpurs()
    {
        for (const FormEdge e : m_form.mesh.edges())
            if (m_form.mesh.is_border(e))
                m_form.cut[e] = false;
        for (Vertex end : looseEnds()) {
            std::vector<FormEdge> spur;
            double length = 0;
            for (Vertex at = end; length <= longestSpur;) {
                std::vector<FormEdge> cuts = cutsAt(at);
                std::erase_if(cuts, [&](FormEdge e) { return std::ranges::find(spur, e) != spur.end(); });
                if (cuts.size() != 1 || (at != end && m_form.mesh.is_border(at)))
                    break;
                spur.push_back(cuts.front());
                length += std::sqrt(CGAL::squared_distance(m_form.mesh.point(m_form.mesh.vertex(cuts.front(), 0)),
                                                           m_form.mesh.point(m_form.mesh.vertex(cuts.front(), 1))));
                at = m_form.mesh.vertex(cuts.front(), m_form.mesh.vertex(cuts.front(), 0) == at ? 1 : 0);
            }
            if (length <= longestSpur)
                for (const FormEdge e : spur)
                    m_form.cut[e] = false;
        }
    }

    Message looseEnd(const Vec3& at, const std::vector<FormLine>& lines) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        std::string name;
        for (const FormLine& line : lines)
            for (const Vec3& place : evenly(line, spacing))
                if (const double distance = (place - at).norm(); distance < nearest) {
                    nearest = distance;
                    name = line.name;
                }
        double border = std::numeric_limits<double>::infinity();
        for (const auto half : m_form.mesh.halfedges())
            if (m_form.mesh.is_border(half))
                border = std::min(border, (fromCgal(m_form.mesh.point(m_form.mesh.target(half))) - at).norm());
        for (const FormLine& line : lines)
            if (line.name != name)
                for (const Vec3& place : evenly(line, spacing))
                    border = std::min(border, (place - at).norm());
        std::string where("(");
        where.append(numberText(at.x(), 4)).append(", ").append(numberText(at.y(), 4)).append(", ");
        where.append(numberText(at.z(), 4)).append(")");
        return {QT_TRANSLATE_NOOP("Message",
                                  "%1 ends inside a piece, at %2: it is cut in there like a dart. The next "
                                  "line or border is %3 mm away; draw it on to there to divide the piece"),
                {name, where, numberText(border, 2)}};
    }

    TriangleSoup m_soup;
    double m_spacing; // mm between places on a line
    Piece m_form;     // as it was, at last cut and tidied
    bool m_whole;
    FaceTree m_tree; // of it as it was
    std::vector<Message> m_notes;
};

bool isAmong(const FormLine& line, const std::vector<FormLine>& lines)
{
    return std::ranges::find(lines, line) != lines.end();
}

/// The draft's cutter, with those lines cut that need not be cut again. The others.
std::vector<FormLine> continued(LineCutter& cutter, FormDraft& draft, const std::vector<FormLine>& lines,
                                const std::stop_token& stop)
{
    const TriangleSoup& uncut = cutter.soup();
    const bool sameForm = draft.uncut.points == uncut.points && draft.uncut.triangles == uncut.triangles &&
                          draft.uncut.part == uncut.part;
    const bool useful =
        sameForm && !draft.cutLines.empty() &&
        std::ranges::all_of(draft.cutLines, [&](const FormLine& line) { return isAmong(line, lines); });
    if (useful) {
        cutter.goOnFrom(draft.cut, draft.notes);
    } else {
        draft.uncut = uncut;
        draft.cutLines.clear(); // as long as cutting may throw
        std::vector<FormLine> cut;
        for (const FormLine& line : lines)
            if (line.points.size() > 1 && sameForm && isAmong(line, draft.lastLines)) {
                cutter.cut(line, lines, stop);
                cut.push_back(line);
            }
        draft.cutLines = std::move(cut);
        draft.cut = cutter.soup();
        draft.notes = cutter.notes();
    }
    draft.lastLines = lines;
    std::vector<FormLine> others;
    for (const FormLine& line : lines)
        if (!isAmong(line, draft.cutLines))
            others.push_back(line);
    return others;
}

} // namespace

LinedTriangles cutAlong(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                        const std::vector<int>& part, const std::vector<FormLine>& lines,
                        const std::stop_token& stop, FormDraft* draft)
{
    LinedTriangles failed;
    failed.problem = {QT_TRANSLATE_NOOP("Message", "lines cannot be cut into it: it has edges where more than two "
                                                   "faces meet, or sheets that touch in a point"),
                      {}};
    LineCutter cutter(points, triangles, part, draft ? draftSpacing : spacing);
    if (!cutter.whole())
        return failed;
    try {
        for (const FormLine& line : draft ? continued(cutter, *draft, lines, stop) : lines) {
            if (stop.stop_requested())
                return {};
            if (line.points.size() > 1)
                cutter.cut(line, lines, stop);
        }
    } catch (const std::exception&) {
        if (stop.stop_requested())
            return {};
        failed.problem = {QT_TRANSLATE_NOOP("Message", "lines cannot be cut into it: it goes through itself there"),
                          {}};
        return failed;
    }
    return cutter.result(lines);
}

} // namespace bolster
