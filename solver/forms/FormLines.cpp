#include "FormLines.h"

#include "FormTree.h"
#include "LinedMesh.h"
#include "SegmentDistance.h"
#include "SharpEdges.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>

namespace bolster {

namespace {

namespace Pmp = CGAL::Polygon_mesh_processing;

constexpr double spacing = 4, draftSpacing = 12; // mm between places on a line
constexpr double ribbon = 1.5;                   // mm that a ribbon stands out on either side
constexpr double shortest = 5, longest = 1e5;    // mm, of a line
constexpr double farthest = 25;                  // mm: what lies farther from the form is no line on it
constexpr double reach =
    11; // mm: a line that ends so near to a border or another line goes on to it (10, and 1 over)
constexpr double leastLoop = 50;                   // mm
constexpr double overshoot = 1;                    // mm, so that they surely cross
constexpr double overEnd = 3;                      // mm
constexpr double overEdge = 5;                     // mm: nobody cuts in so little behind an edge
constexpr double offForm = 0.05, samePlace = 1e-6; // mm
constexpr double sameLine = 2.5;                   // mm: nobody sews what is narrower

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

std::vector<Vec3> evenly(const FormLine& line, double apart)
{
    std::vector<Vec3> places{line.points.front()};
    std::vector<Vec3> corners = line.points;
    if (line.closed)
        corners.push_back(corners.front());
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const Vec3 from = corners[k - 1], way = corners[k] - from;
        const int steps = static_cast<int>(std::ceil(way.norm() / apart)); // none where two points are one
        for (int i = 1; i <= steps; ++i)
            places.emplace_back(from + way * i / steps);
    }
    return places;
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

/// Where a mesh goes through itself, if it does.
std::optional<Vec3> selfCrossing(const CgalMesh& mesh)
{
    std::vector<std::pair<Face, Face>> pairs;
    Pmp::self_intersections(mesh, std::back_inserter(pairs));
    if (pairs.empty())
        return std::nullopt;
    Vec3 sum = Vec3::Zero();
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(pairs.front().first)))
        sum += fromCgal(mesh.point(v)) / 3;
    return sum;
}

/// About where a line lies.
std::string middleOf(const FormLine& line)
{
    return placeText(line.points[line.points.size() / 2]);
}

/// A line that is not refused.
struct CutLine {
    FormLine line;
    std::vector<Vec3> places = {}; ///< as it goes on to others
    bool isCut = false;            ///< not where it cuts nothing, or not yet
};

class LineCutter {
public:
    LineCutter(const TriangleSoup& form, const FormCuts& cuts, double apart, const std::stop_token& stop)
        : m_soup(form)
        , m_cuts(cuts)
        , m_spacing(apart)
        , m_whole(m_form.build(m_soup, {}, stop))
        , m_tree(trianglesOf(m_soup), stop)
        , m_sharp(m_soup)
    {
        for (const FormLine& line : m_cuts.lines)
            if (m_whole && !stop.stop_requested() && line.points.size() > 1 && whyRefused(line).empty())
                m_lines.push_back({line, placesOf(line)});
    }

    bool whole() const { return m_whole; }
    const Vec3& notWholeAt() const { return m_form.refusedAt(); }
    const FormLine& lastLine() const { return m_lastLine; }
    const TriangleSoup& soup() const { return m_soup; }
    const std::vector<Message>& notes() const { return m_notes; }
    /// As it was when some lines had been cut.
    void goOnFrom(const TriangleSoup& soup, const std::vector<Message>& notes)
    {
        m_soup = soup;
        m_notes = notes;
        for (CutLine& each : m_lines)
            each.isCut = true;
    }

    void cut(const FormLine& line, const std::stop_token& stop)
    {
        m_lastLine = line;
        if (Message why = whyRefused(line); !why.empty()) {
            m_notes.push_back(std::move(why));
            return;
        }
        m_current = static_cast<std::size_t>(std::ranges::find(m_lines, line, &CutLine::line) - m_lines.begin());
        for (const CutLine& earlier : std::span(m_lines).first(m_current))
            if (earlier.isCut && runsAlong(line, earlier.line)) {
                m_notes.push_back({QT_TRANSLATE_NOOP("Message", "%1 runs along %2, at %3: it is cut there once"),
                                   {line.name, earlier.line.name, middleOf(line)}});
                return;
            }
        const std::vector<FormLine> parts = awayFromBorder(comesBack(line) ? closed(line) : endedOnEdges(line));
        if (parts.empty())
            m_notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "%1 runs along the border of the form, or where it is cut anyway, "
                                              "at %2: there is nothing to cut"),
                 {line.name, middleOf(line)}});
        m_lines[m_current].isCut = !parts.empty();
        for (const FormLine& part : parts)
            cutPart(part, stop);
    }

    LinedTriangles result()
    {
        m_form.build(m_soup, {});
        const auto parts = [&](Vertex v) { return isCutAnywayAt(v); };
        m_form.pruneSpurs(parts);
        m_form.tidy();
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
        for (const Vertex v : m_form.looseEnds(parts))
            result.notes.push_back(looseEnd(fromCgal(m_form.mesh.point(v))));
        return result;
    }

private:
    /// Empty where it may be cut along it.
    Message whyRefused(const FormLine& line) const
    {
        if (const double length = lengthOf(line.points); !(length > shortest && length < longest))
            return {QT_TRANSLATE_NOOP("Message", "%1 is too short or too long, at %2: it is not cut along it"),
                    {line.name, middleOf(line)}};
        if (const auto [away, at] = distanceOf(line); away > farthest)
            return {QT_TRANSLATE_NOOP("Message", "%1 is %2 mm away from the form, at %3: it is not cut along it"),
                    {line.name, numberText(away, 2), placeText(at)}};
        return {};
    }

    /// Whether it would go on from its end to its own beginning.
    static bool comesBack(const FormLine& line)
    {
        return !line.closed && line.points.size() > 3 && lengthOf(line.points) > leastLoop &&
               (line.points.front() - line.points.back()).norm() < reach;
    }

    /// All of it.
    static bool runsAlong(const FormLine& line, const FormLine& other)
    {
        const std::vector<Vec3> places = evenly(other, sameLine / 2);
        return std::ranges::all_of(evenly(line, spacing), [&](const Vec3& point) {
            return std::ranges::any_of(places,
                                       [&](const Vec3& place) { return (place - point).norm() <= sameLine; });
        });
    }

    static FormLine closed(FormLine line)
    {
        line.closed = true;
        if ((line.points.front() - line.points.back()).norm() < shortest)
            line.points.pop_back();
        return line;
    }

    /// Without what was drawn over a border, or an edge that is sharp or cut anyway, by a few mm at its ends.
    FormLine endedOnEdges(FormLine line) const
    {
        for (int end = 0; end < 2 && !line.closed; ++end) {
            endOnEdge(line.points);
            std::ranges::reverse(line.points);
        }
        return line;
    }

    void endOnEdge(std::vector<Vec3>& points) const
    {
        constexpr double step = 0.25, on = 0.3; // mm
        constexpr double mostAlong = 0.4;       // sine of the angle at which it leaves the edge at least
        const Vec3 end = points.back();
        bool isOver = isOutside(end); // beside the form
        if (!isOver && edgeNear(end, on))
            return;
        double length = 0; // back to where the segment begins
        for (std::size_t k = points.size() - 1; k > 0; --k) {
            const Vec3 from = points[k], way = points[k - 1] - from;
            for (double along = step; along < way.norm(); along += step) {
                const double over = length + along;
                const Vec3 at = from + along / way.norm() * way;
                if (over > (isOver ? farthest : overEdge))
                    return;
                const std::optional<Vec3> edge = isOver && isOutside(at) ? std::nullopt : edgeNear(at, on);
                if (!edge)
                    continue;
                if (const std::optional<Vec3> beside = edgeNear(end, over);
                    beside && (*beside - end).norm() < mostAlong * over)
                    return; // it runs along it
                points.resize(k);
                points.push_back(*edge);
                return;
            }
            length += way.norm();
        }
    }

    /// The place on such an edge that is nearest to where a line's place lies on the form.
    std::optional<Vec3> edgeNear(const Vec3& at, double within) const
    {
        const Vec3 on = m_tree.nearestTo(at).at;
        std::optional<Vec3> edge = borderNear(on);
        if (const std::optional<Vec3> sharp = m_sharp.nearest(on);
            sharp && (!edge || (*sharp - on).norm() < (*edge - on).norm()))
            edge = sharp;
        return edge && (*edge - on).norm() < within ? edge : std::nullopt;
    }

    static Message whyNotCut(const FormLine& line, const CgalMesh& strip, const CgalMesh& form)
    {
        if (const std::optional<Vec3> sharp = selfCrossing(strip))
            return {QT_TRANSLATE_NOOP("Message", "%1 bends too sharply at %2: it is not cut along it"),
                    {line.name, placeText(*sharp)}};
        return {QT_TRANSLATE_NOOP("Message", "The form goes through itself at %2: it is not cut along %1"),
                {line.name, placeText(selfCrossing(form).value_or(line.points.front()))}};
    }

    std::vector<LineRun> runsOf(const FormLine& line, double apart) const
    {
        std::vector<SharpEdges::Place> places;
        for (const Vec3& at : evenly(line, apart))
            places.push_back({at, m_tree.nearestTo(at).at});
        return m_sharp.runsOf(std::move(places), line.closed);
    }

    /// As it goes on to others: on sharp edges where it runs along those.
    std::vector<Vec3> placesOf(const FormLine& line) const
    {
        std::vector<Vec3> places;
        for (const LineRun& run : runsOf(line, spacing / 2))
            places.insert(places.end(), run.places.begin(), run.places.end());
        return places;
    }

    void cutPart(const FormLine& line, const std::stop_token& stop)
    {
        std::vector<LineRun> runs = runsOf(line, m_spacing);
        if (std::ranges::none_of(runs, &LineRun::onEdges)) {
            cutNow(line, {}, stop);
            return;
        }
        leadOn(runs, line);
        for (std::size_t k = 0; k < runs.size(); ++k) {
            if (!runs[k].onEdges)
                continue;
            runs[k].onEdges = m_sharp.cut(m_soup, runs[k]);
            if (k > 0)
                runs[k - 1].places.back() = runs[k].places.front();
            if (k + 1 < runs.size())
                runs[k + 1].places.front() = runs[k].places.back();
        }
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const bool goesOn = line.closed && runs.size() > 1;
            if (!runs[k].onEdges)
                cutNow({line.name, std::move(runs[k].places), line.closed && runs.size() == 1},
                       {k > 0 || goesOn, k + 1 < runs.size() || goesOn}, stop);
        }
    }

    /// What a line has besides where it runs along edges may be no more than how far it was drawn over their ends;
    /// and where it ends on an edge a little before a border or another line it goes on to there.
    void leadOn(std::vector<LineRun>& runs, const FormLine& line) const
    {
        const auto isOver = [&](const LineRun& run) {
            const double length = lengthOf(run.places);
            return !run.onEdges &&
                   (length < overEnd || (length < 2 * reach && std::ranges::any_of(run.places, [&](const Vec3& at) {
                                             return isOutside(at);
                                         })));
        };
        if (line.closed)
            return;
        if (isOver(runs.back()))
            runs.pop_back();
        if (isOver(runs.front()))
            runs.erase(runs.begin());
        if (runs.back().onEdges)
            leadOn(runs.back().places);
        if (runs.front().onEdges) {
            std::ranges::reverse(runs.front().places);
            leadOn(runs.front().places);
            std::ranges::reverse(runs.front().places);
        }
    }

    void leadOn(std::vector<Vec3>& places) const
    {
        const Vec3& end = places.back();
        const Vec3 direction = (end - places[places.size() - 2]).normalized();
        if (const std::optional<Vec3> ahead = placeAhead(end, direction))
            if (const std::optional<Vec3> on = m_sharp.nearest(*ahead + overshoot * direction))
                places.push_back(*on);
    }

    /// Whether its ends are on edges that are cut, where it stops.
    using Joined = std::pair<bool, bool>;

    void cutNow(const FormLine& line, const Joined& joined, const std::stop_token& stop)
    {
        CgalMesh strip = ribbonAlong(line, joined);
        LinedMesh near;
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
            m_notes.push_back(whyNotCut(line, strip, near.mesh));
            m_lines[m_current].isCut = false;
            return;
        }
        near.tidy(); // the next line meets whole triangles
        near.putBack(m_soup);
    }

    static std::vector<FormTree::Triangle> trianglesOf(const TriangleSoup& soup)
    {
        std::vector<FormTree::Triangle> triangles;
        for (const auto& [a, b, c] : soup.triangles)
            triangles.push_back({soup.points[a], soup.points[b], soup.points[c]});
        return triangles;
    }

    /// The face that is nearest to a place on the form.
    std::pair<Vec3, Face> faceNear(const Vec3& place) const
    {
        const auto [at, triangle] = m_tree.nearestTo(place);
        return {at, Face(triangle)}; // the mesh has been made of all triangles, in their order
    }

    /// Of most of its places, mm, and such a place.
    std::pair<double, Vec3> distanceOf(const FormLine& line) const
    {
        std::vector<std::pair<double, Vec3>> distances;
        for (const Vec3& place : line.points)
            distances.emplace_back((m_tree.nearestTo(place).at - place).norm(), place);
        std::ranges::stable_sort(distances, {}, [](const auto& distance) { return distance.first; });
        return distances[distances.size() / 2];
    }

    LinePlace placeOf(const Vec3& at) const
    {
        const auto [near, triangle] = m_tree.nearestTo(at);
        const auto& [a, b, c] = m_tree.triangle(triangle);
        return {near, (b - a).cross(c - a).normalized(), (at - near).norm()};
    }

    /// Whether a place lies beside the form, outside of its border.
    bool isBeyond(const Vec3& at) const
    {
        const auto [place, face] = faceNear(at);
        if ((place - at).norm() < offForm)
            return false;
        const Kernel::Point_3 near = toCgal(place);
        for (const auto half : m_form.mesh.halfedges_around_face(m_form.mesh.halfedge(face))) {
            const Kernel::Point_3 &a = m_form.mesh.point(m_form.mesh.source(half)),
                                  &b = m_form.mesh.point(m_form.mesh.target(half));
            const bool isAtCorner = m_form.mesh.is_border(m_form.mesh.target(half)) &&
                                    CGAL::squared_distance(near, b) < samePlace * samePlace;
            const bool isOnEdge = m_form.mesh.is_border(m_form.mesh.edge(half)) &&
                                  CGAL::squared_distance(near, Kernel::Segment_3(a, b)) < samePlace * samePlace;
            if (isAtCorner || isOnEdge)
                return true;
        }
        return false;
    }

    /// Or outside of a sharp edge, where the form goes on in another direction.
    bool isOutside(const Vec3& at) const
    {
        if (isBeyond(at))
            return true;
        const Vec3 place = m_tree.nearestTo(at).at;
        const std::optional<Vec3> edge = m_sharp.nearest(place);
        return (place - at).norm() >= offForm && edge && (*edge - place).norm() < samePlace;
    }

    /// Whether the form ends there, or is cut there whatever lines say.
    bool isCutAnyway(FormEdge edge) const
    {
        if (m_form.mesh.is_border(edge) || m_form.cut[edge])
            return true;
        const auto half = m_form.mesh.halfedge(edge), other = m_form.mesh.opposite(half);
        if (m_cuts.groups && m_form.part[m_form.mesh.face(half)] != m_form.part[m_form.mesh.face(other)])
            return true;
        return m_cuts.angle &&
               normalBeside(half).dot(normalBeside(other)) < std::cos(*m_cuts.angle * std::numbers::pi / 180);
    }

    /// Of edges that no line has cut.
    bool isCutAnywayAt(Vertex v) const
    {
        const auto around = m_form.mesh.halfedges_around_target(m_form.mesh.halfedge(v));
        return std::ranges::any_of(around, [&](auto half) {
            const FormEdge e = m_form.mesh.edge(half);
            return !m_form.cut[e] && isCutAnyway(e);
        });
    }

    Vec3 normalBeside(CgalMesh::Halfedge_index half) const
    {
        const Vec3 from = fromCgal(m_form.mesh.point(m_form.mesh.source(half)));
        const Vec3 to = fromCgal(m_form.mesh.point(m_form.mesh.target(half)));
        const Vec3 third = fromCgal(m_form.mesh.point(m_form.mesh.target(m_form.mesh.next(half))));
        return (to - from).cross(third - from).normalized();
    }

    /// The place of a border, or of where it is cut anyway, that is nearest to a place on the form; none where none
    /// is near.
    std::optional<Vec3> borderNear(const Vec3& at) const
    {
        const Face face = faceNear(at).second;
        std::optional<Vec3> found;
        for (const Vertex v : m_form.mesh.vertices_around_face(m_form.mesh.halfedge(face)))
            for (const auto half : m_form.mesh.halfedges_around_target(m_form.mesh.halfedge(v))) {
                if (!isCutAnyway(m_form.mesh.edge(half)))
                    continue;
                const auto [from, to] = endsOf(m_form.mesh.edge(half));
                const Vec3 place = nearestOnSegment<3>(at, from, to);
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
        const auto isInside = [&](const Vec3& at) { return !isOutside(at); };
        const auto first = std::ranges::find_if(places, isInside);
        if (first == places.end())
            return {false, false};
        const auto last = std::find_if(places.rbegin(), places.rend(), isInside).base(); // behind the last one
        const bool starts = first != places.begin(), ends = last != places.end();
        places = std::vector<Vec3>(first - static_cast<int>(starts), last + static_cast<int>(ends));
        return {starts, ends};
    }

    /// What a line that ends on the form may go on to: the nearest place of a border, of where it is cut anyway, or
    /// of another line, within reach, and neither beside nor behind.
    std::optional<Vec3> placeAhead(const Vec3& end, const Vec3& direction) const
    {
        constexpr double mostAside = 0.25; // cosine of the angle by which it turns at most
        std::optional<Vec3> found;
        double nearest = reach;
        const auto look = [&](const Vec3& place) {
            const double distance = (place - end).norm();
            const bool isThere = distance < offForm; // in which direction is chance
            if (distance < nearest && (isThere || (place - end).dot(direction) > mostAside * distance)) {
                nearest = distance;
                found = place;
            }
        };
        for (const FormEdge e : m_form.mesh.edges())
            if (const auto [a, b] = endsOf(e); segmentDistance<3>(end, a, b) < reach && isCutAnyway(e))
                look(nearestOnSegment<3>(end, a, b));
        for (std::size_t k = 0; k < m_lines.size(); ++k)
            if (k != m_current)
                for (const Vec3& place : m_lines[k].places)
                    if ((place - end).norm() < reach + farthest) // both as they lie on the form
                        look(m_tree.nearestTo(place).at);
        return found;
    }

    std::pair<Vec3, Vec3> endsOf(FormEdge e) const
    {
        return {fromCgal(m_form.mesh.point(m_form.mesh.vertex(e, 0))),
                fromCgal(m_form.mesh.point(m_form.mesh.vertex(e, 1)))};
    }

    /// One place more behind the end of a line: a little beyond what is near, or else straight on.
    Vec3 goneOn(const Vec3& end, const Vec3& before) const
    {
        const Vec3 straight = (end - before).normalized(), on = m_tree.nearestTo(end).at;
        const std::optional<Vec3> ahead = placeAhead(on, straight);
        const double missing = ahead ? (*ahead - on).norm() : 0;
        return missing > overshoot ? Vec3(*ahead + overshoot / missing * (*ahead - on))
                                   : Vec3(end + (missing + overshoot) * straight);
    }

    /// On to a border or another line that is near, where it is not outside of the border.
    void prolong(std::vector<Vec3>& places, const FormLine& line, const Joined& joined) const
    {
        const auto [starts, ends] = trim(places, line);
        if (line.closed || places.size() < 2)
            return;
        const auto over = [&](const Vec3& end, const Vec3& before) {
            return Vec3(end + overshoot * (end - before).normalized());
        };
        const Vec3 &second = places[1], &last = places.back(), &lastBut = places[places.size() - 2];
        const Vec3 before = joined.first ? over(places.front(), second) : goneOn(places.front(), second);
        const Vec3 behind = joined.second ? over(last, lastBut) : goneOn(last, lastBut);
        if (!starts)
            places.insert(places.begin(), before);
        if (!ends)
            places.push_back(behind);
    }

    /// A ribbon that ends on a sharp edge stands there as it does before: the normal on the edge is that of either
    /// side, and what lies beyond it is of no account.
    void settleEnd(std::span<LinePlace> on) const
    {
        constexpr double same = 0.01; // mm
        constexpr std::size_t most = 4;
        const auto isOnEdge = [&](const LinePlace& place) {
            const std::optional<Vec3> edge = m_sharp.nearest(place.at);
            return edge && (*edge - place.at).norm() < same;
        };
        std::size_t inside = on.size() > 1 && isOnEdge(on[1]) ? 1 : 0;
        while (inside < std::min(on.size(), most) && isOnEdge(on[inside]))
            ++inside;
        if (inside < std::min(on.size(), most))
            for (std::size_t k = 0; k < inside; ++k)
                on[k].normal = on[inside].normal;
    }

    CgalMesh ribbonAlong(const FormLine& line, const Joined& joined) const
    {
        std::vector<Vec3> places = evenly(line, m_spacing);
        prolong(places, line, joined);
        std::vector<LinePlace> on;
        for (const Vec3& place : places)
            on.push_back(placeOf(place));
        settleEnd(std::span(on));
        std::ranges::reverse(on);
        settleEnd(std::span(on));
        std::ranges::reverse(on);
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

    Message looseEnd(const Vec3& at) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t own = 0;
        for (std::size_t k = 0; k < m_lines.size(); ++k)
            for (const Vec3& place : m_lines[k].places)
                if (const double distance = (place - at).norm(); distance < nearest) {
                    nearest = distance;
                    own = k;
                }
        const std::string name = m_lines.empty() ? std::string() : m_lines[own].line.name;
        double border = std::numeric_limits<double>::infinity();
        for (const FormEdge e : m_form.mesh.edges())
            if (!m_form.cut[e] && isCutAnyway(e)) {
                const auto [a, b] = endsOf(e);
                border = std::min(border, segmentDistance<3>(at, a, b));
            }
        for (std::size_t k = 0; k < m_lines.size(); ++k)
            if (k != own)
                for (const Vec3& place : m_lines[k].places)
                    border = std::min(border, (place - at).norm());
        if (!std::isfinite(border))
            return {QT_TRANSLATE_NOOP("Message",
                                      "%1 ends inside a piece, at %2: it is cut in there like a dart. There is no "
                                      "other line or border; lead it around to where it began to divide the piece"),
                    {name, placeText(at)}};
        return {QT_TRANSLATE_NOOP("Message",
                                  "%1 ends inside a piece, at %2: it is cut in there like a dart. The next "
                                  "line or border is %3 mm away; draw it on to there to divide the piece"),
                {name, placeText(at), numberText(border, 2)}};
    }

    TriangleSoup m_soup;
    const FormCuts& m_cuts;
    double m_spacing; // mm between places on a line
    LinedMesh m_form; // as it was, at last cut and tidied
    bool m_whole;
    FormTree m_tree; // of it as it was
    std::vector<Message> m_notes;
    std::vector<CutLine> m_lines; // nothing goes on to the others
    std::size_t m_current = 0;    // of them, that is cut
    SharpEdges m_sharp;           // of the form as it was
    FormLine m_lastLine;          // that was to be cut
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
                          draft.uncut.part == uncut.part && draft.uncut.cuts == uncut.cuts;
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
                cutter.cut(line, stop);
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

std::string placeText(const Vec3& at)
{
    const auto number = [](double value) { return numberText(std::round(100 * value) / 100, 4); };
    std::string text("(");
    text.append(number(at.x())).append(", ").append(number(at.y())).append(", ");
    return text.append(number(at.z())).append(")");
}

LinedTriangles cutAlong(const TriangleSoup& form, const FormCuts& cuts, const std::stop_token& stop,
                        FormDraft* draft)
{
    const std::vector<FormLine>& lines = cuts.lines;
    LinedTriangles failed;
    LineCutter cutter(form, cuts, draft ? draftSpacing : spacing, stop);
    if (stop.stop_requested())
        return {};
    if (!cutter.whole()) {
        failed.problem = {QT_TRANSLATE_NOOP("Message", "lines cannot be cut into it: it has edges where more than "
                                                       "two faces meet, or sheets that touch in a point, at %1"),
                          {placeText(cutter.notWholeAt())}};
        return failed;
    }
    try {
        for (const FormLine& line : draft ? continued(cutter, *draft, lines, stop) : lines) {
            if (stop.stop_requested())
                return {};
            if (line.points.size() > 1)
                cutter.cut(line, stop);
        }
    } catch (const std::exception&) {
        if (stop.stop_requested())
            return {};
        failed.problem = {QT_TRANSLATE_NOOP("Message", "%1 cannot be cut into it, at %2: the form goes through "
                                                       "itself there"),
                          {cutter.lastLine().name, middleOf(cutter.lastLine())}};
        return failed;
    }
    return cutter.result();
}

} // namespace bolster
