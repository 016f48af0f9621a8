#include "FormLines.h"

#include "LineEnds.h"
#include "OpenEnds.h"
#include "UnionFind.h"

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

// CGAL's corefinement orders boxes that begin at the same coordinate by where they lie in memory: what the program
// did before decided how a form is cut. They are numbered instead, in the order in which they are made.
namespace CGAL::Box_intersection_d {
template <>
class Box_with_info_d<double, 3, SM_Halfedge_index, ID_FROM_BOX_ADDRESS>
    : public Box_with_info_d<double, 3, SM_Halfedge_index, ID_EXPLICIT> {
public:
    using Box_with_info_d<double, 3, SM_Halfedge_index, ID_EXPLICIT>::Box_with_info_d;
};
} // namespace CGAL::Box_intersection_d

namespace bolster {

namespace {

namespace Pmp = CGAL::Polygon_mesh_processing;

constexpr double spacing = 4, draftSpacing = 12; // mm between places on a line
constexpr double ribbon = 1.5;                   // mm that a ribbon stands out on either side
constexpr double oneSection = 0.1;               // mm: no two sections of it are so near each other
constexpr double deep = 0.5;                     // mm below the form: there a ribbon may pass it by
constexpr int mostBridges = 5;                   // divisions of such a step into halves
constexpr double longest = 1e5;                  // mm, of a line
constexpr double sameLine = 2.5;                 // mm: nobody sews what is narrower

/// Across a line: how far a ribbon stands out below the form and above it, mm.
struct RibbonSection {
    Vec3 middle, normal;
    double below = ribbon, above = ribbon;
};

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

class LineCutter {
public:
    LineCutter(const TriangleSoup& form, const FormCuts& cuts, double apart, const std::stop_token& stop)
        : m_soup(form)
        , m_cuts(cuts)
        , m_spacing(apart)
        , m_form(m_soup, cuts, stop)
    {
        if (whole() && !stop.stop_requested())
            m_soup.ends = m_form.loosePoints();
        for (const FormLine& line : m_cuts.lines)
            if (whole() && !stop.stop_requested() && line.points.size() > 1 && whyRefused(line).empty())
                m_lines.push_back({line, placesOf(line)});
    }

    bool whole() const { return m_form.whole(); }
    const Vec3& notWholeAt() const { return m_form.notWholeAt(); }
    const FormLine& lastLine() const { return m_lastLine; }
    const TriangleSoup& soup() const { return m_soup; }
    const std::vector<Message>& notes() const { return m_notes; }
    /// As it was when some lines had been cut.
    void goOnFrom(const TriangleSoup& soup, const std::vector<Message>& notes)
    {
        m_soup = soup;
        m_notes = notes;
        for (LineToCut& each : m_lines)
            each.isCut = true;
    }

    void cut(const FormLine& line, const std::stop_token& stop)
    {
        m_lastLine = line;
        if (Message why = whyRefused(line); !why.empty()) {
            m_notes.push_back(std::move(why));
            return;
        }
        m_current = static_cast<std::size_t>(std::ranges::find(m_lines, line, &LineToCut::line) - m_lines.begin());
        for (const LineToCut& earlier : std::span(m_lines).first(m_current))
            if (earlier.isCut && runsAlong(line, earlier.line)) {
                m_notes.push_back({QT_TRANSLATE_NOOP("Message", "%1 runs along %2, at %3: it is cut there once"),
                                   {line.name, earlier.line.name, middleOf(line)}});
                return;
            }
        const std::vector<FormLine> parts = ends().parts(line);
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
        LinedMesh form;
        form.build(m_soup, {});
        form.pruneSpurs(m_cuts);
        form.tidy();
        LinedTriangles result;
        result.notes = m_notes;
        std::map<Vertex, int> number;
        for (const Vertex v : form.mesh.vertices()) {
            number[v] = static_cast<int>(result.points.size());
            result.points.push_back(fromCgal(form.mesh.point(v)));
        }
        for (const Face f : form.mesh.faces()) {
            std::array<int, 3> corners{};
            int k = 0;
            for (const Vertex v : form.mesh.vertices_around_face(form.mesh.halfedge(f)))
                corners[static_cast<std::size_t>(k++)] = number[v];
            result.triangles.push_back(corners);
            result.part.push_back(form.part[f]);
        }
        for (const FormEdge e : form.mesh.edges())
            if (form.cut[e]) {
                const int a = number[form.mesh.vertex(e, 0)], b = number[form.mesh.vertex(e, 1)];
                result.cuts.insert({std::min(a, b), std::max(a, b)});
            }
        for (const Vertex v : form.looseEnds(m_cuts)) {
            result.openEnds.push_back(openEndAt(fromCgal(form.mesh.point(v)), m_form, m_lines));
            result.notes.push_back(result.openEnds.back().note);
        }
        return result;
    }

private:
    LineEnds ends() const { return {m_form, m_lines, m_current, m_spacing}; }

    /// Empty where it may be cut along it.
    Message whyRefused(const FormLine& line) const
    {
        if (const double length = lengthOf(line.points); !(length > shortestLine && length < longest))
            return {QT_TRANSLATE_NOOP("Message", "%1 is too short or too long, at %2: it is not cut along it"),
                    {line.name, middleOf(line)}};
        if (const auto [away, at] = distanceOf(line); away > farthestLine)
            return {QT_TRANSLATE_NOOP("Message", "%1 is %2 mm away from the form, at %3: it is not cut along it"),
                    {line.name, numberText(away, 2), placeText(at)}};
        return {};
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

    static Message whyNotCut(const FormLine& line, const CgalMesh& strip, const Vec3& crossing)
    {
        if (const std::optional<Vec3> sharp = selfCrossing(strip))
            return {QT_TRANSLATE_NOOP("Message", "%1 bends too sharply at %2: it is not cut along it"),
                    {line.name, placeText(*sharp)}};
        return {QT_TRANSLATE_NOOP("Message", "The form goes through itself at %2: it is not cut along %1"),
                {line.name, placeText(crossing)}};
    }

    std::vector<LineRun> runsOf(const FormLine& line, double apart) const
    {
        std::vector<SharpEdges::Place> places;
        for (const Vec3& at : evenly(line, apart))
            places.push_back({at, m_form.nearest(at)});
        return m_form.sharpEdges().runsOf(std::move(places), line.closed);
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
        ends().leadOn(runs, line);
        for (std::size_t k = 0; k < runs.size(); ++k) {
            if (!runs[k].onEdges)
                continue;
            runs[k].onEdges = m_form.sharpEdges().cut(m_soup, runs[k]);
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

    void cutNow(const FormLine& line, const LineEnds::Joined& joined, const std::stop_token& stop)
    {
        const CgalMesh strip = ribbonAlong(line, joined);
        const std::vector<int> near = trianglesNear(m_soup, strip);
        if (cutBy(strip, near, stop).isCut)
            return;
        // Sheets that go through each other are cut one by one.
        const std::vector<int> sheetOf = sheetsOfPoints(near);
        const std::set<int> sheets(sheetOf.begin(), sheetOf.end());
        std::optional<Vec3> crossing;
        bool isCut = false;
        for (const int sheet : sheets) {
            if (sheet < 0)
                continue;
            std::vector<int> own = trianglesNear(m_soup, strip);
            std::erase_if(own, [&](int t) { return !isOf(sheet, sheetOf, m_soup.triangles[t]); });
            const Cut cut = cutBy(strip, std::move(own), stop);
            isCut = isCut || cut.isCut;
            if (!cut.isCut && !crossing)
                crossing = cut.crossing;
        }
        if (crossing)
            m_notes.push_back(whyNotCut(line, strip, *crossing));
        m_lines[m_current].isCut = isCut;
    }

    /// Along a ribbon; or where the triangles that it meets go through each other.
    struct Cut {
        bool isCut = true;
        Vec3 crossing = Vec3::Zero();
    };

    Cut cutBy(CgalMesh strip, std::vector<int> triangles, const std::stop_token& stop)
    {
        LinedMesh near;
        // Where sheets touch in a point when they are taken alone, all of it is.
        if (!near.build(m_soup, std::move(triangles)))
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
            return {false, selfCrossing(near.mesh).value_or(fromCgal(*strip.points().begin()))};
        }
        near.renumberEdges();
        near.tidy(); // the next line meets whole triangles
        near.putBack(m_soup);
        return {};
    }

    /// Of each point which sheet of these triangles it lies on, none where on none: they have no point in common.
    std::vector<int> sheetsOfPoints(const std::vector<int>& triangles) const
    {
        UnionFind points(static_cast<int>(m_soup.points.size()));
        for (const int t : triangles)
            for (const int corner : m_soup.triangles[t])
                points.join(m_soup.triangles[t][0], corner);
        std::vector<int> sheets(m_soup.points.size(), -1);
        for (const int t : triangles)
            for (const int corner : m_soup.triangles[t])
                sheets[corner] = points.root(corner);
        return sheets;
    }

    /// New points are those of a sheet that has been cut.
    static bool isOf(int sheet, const std::vector<int>& sheetOf, const std::array<int, 3>& corners)
    {
        return std::ranges::all_of(corners, [&](int corner) {
            return corner < std::ssize(sheetOf) && sheetOf[static_cast<std::size_t>(corner)] == sheet;
        });
    }

    /// Of most of its places, mm, and such a place.
    std::pair<double, Vec3> distanceOf(const FormLine& line) const
    {
        std::vector<std::pair<double, Vec3>> distances;
        for (const Vec3& place : line.points)
            distances.emplace_back((m_form.nearest(place) - place).norm(), place);
        std::ranges::stable_sort(distances, {}, [](const auto& distance) { return distance.first; });
        return distances[distances.size() / 2];
    }

    /// A ribbon that ends on a sharp edge stands there as it does before: the normal on the edge is that of either
    /// side, and what lies beyond it is of no account.
    void settleEnd(std::span<LinePlace> on) const
    {
        constexpr double same = 0.01; // mm
        constexpr std::size_t most = 4;
        const auto isOnEdge = [&](const LinePlace& place) {
            const std::optional<Vec3> edge = m_form.sharpEdges().nearest(place.at);
            return edge && (*edge - place.at).norm() < same;
        };
        std::size_t inside = on.size() > 1 && isOnEdge(on[1]) ? 1 : 0;
        while (inside < std::min(on.size(), most) && isOnEdge(on[inside]))
            ++inside;
        if (inside < std::min(on.size(), most))
            for (std::size_t k = 0; k < inside; ++k)
                on[k].normal = on[inside].normal;
    }

    /// Between two places of a line that is drawn through an edge of the form, not over it, a ribbon would pass
    /// below the edge: it goes there by the edge itself.
    void bridge(std::vector<LinePlace>& on, const LinePlace& to, int most) const
    {
        const LinePlace from = on.back();
        const Vec3 middle = 0.5 * (from.at + to.at);
        LinePlace between = m_form.placeOf(middle);
        if (most == 0 || between.away <= deep)
            return;
        if (const std::optional<Vec3> edge = m_form.sharpEdges().nearest(middle))
            between = {*edge, (from.normal + to.normal).normalized(), 0};
        else
            bridge(on, between, most - 1);
        on.push_back(between);
        bridge(on, to, most - 1);
    }

    /// Where a ribbon goes around an edge of the form its sections come nearer to each other on one side, where
    /// they must not cross. There the form lies on the other side.
    static void narrowBends(std::vector<RibbonSection>& across)
    {
        constexpr double most = 0.45; // of the way to where two would meet
        const auto part = [&](RibbonSection& a, RibbonSection& b) {
            const Vec3 way = b.middle - a.middle;
            const double apart = way.norm(), spread = (b.normal - a.normal).dot(way) / std::max(apart, 1e-9);
            double RibbonSection::*const side = spread > 0 ? &RibbonSection::below : &RibbonSection::above;
            const double room = most * apart / std::max(std::abs(spread), 1e-9);
            a.*side = std::min(a.*side, room);
            b.*side = std::min(b.*side, room);
        };
        for (std::size_t k = 0; k < across.size(); ++k)
            for (std::size_t i = k + 1; i < across.size(); ++i) {
                part(across[k], across[i]);
                if ((across[i].middle - across[k].middle).norm() > 2 * ribbon)
                    break;
            }
    }

    CgalMesh ribbonAlong(const FormLine& line, const LineEnds::Joined& joined) const
    {
        std::vector<Vec3> places = evenly(line, m_spacing);
        ends().prolong(places, line, joined);
        std::vector<LinePlace> on;
        for (const Vec3& place : places) {
            const LinePlace next = m_form.placeOf(place);
            if (!on.empty())
                bridge(on, next, mostBridges);
            const bool isLast = &place == &places.back();
            if (on.size() > 1 && (next.at - on.back().at).norm() < oneSection) {
                if (!isLast)
                    continue;
                on.pop_back();
            }
            on.push_back(next);
        }
        settleEnd(std::span(on));
        std::ranges::reverse(on);
        settleEnd(std::span(on));
        std::ranges::reverse(on);
        std::vector<RibbonSection> across;
        for (std::size_t k = 0; k < on.size(); ++k) {
            Vec3 normal = Vec3::Zero(); // of neighbours too: at an edge of the form it turns
            for (std::size_t i = k > 0 ? k - 1 : 0; i <= std::min(k + 1, on.size() - 1); ++i)
                normal += on[i].normal;
            // What was prolonged beyond the border stays there: it is not pulled back to it.
            const bool beyond = (k == 0 || k + 1 == on.size()) && !line.closed;
            const double width = ribbon + (beyond ? on[k].away : 0);
            across.push_back(
                {beyond ? (k == 0 ? places.front() : places.back()) : on[k].at, normal.normalized(), width, width});
        }
        narrowBends(across);
        CgalMesh strip;
        std::vector<std::pair<Vertex, Vertex>> sections;
        for (const RibbonSection& section : across)
            sections.emplace_back(strip.add_vertex(toCgal(section.middle - section.below * section.normal)),
                                  strip.add_vertex(toCgal(section.middle + section.above * section.normal)));
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

    TriangleSoup m_soup;
    const FormCuts& m_cuts;
    double m_spacing; // mm between places on a line
    UncutForm m_form;
    std::vector<Message> m_notes;
    std::vector<LineToCut> m_lines; // nothing goes on to the others
    std::size_t m_current = 0;      // of them, that is cut
    FormLine m_lastLine;            // that was to be cut
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
