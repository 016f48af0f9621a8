#include "Form.h"

#include "BodyCrossings.h"
#include "BorderRows.h"
#include "FormLines.h"
#include "HalfEdges.h"
#include "ThinForm.h"
#include "UnionFind.h"
#include "WeldedForm.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <set>

namespace bolster {

namespace {

using Corners = WeldedForm::Corners;
using Edge = std::pair<int, int>; // of points, the lesser one first

constexpr int samplesOfSpan = 8;                             // of a curve
constexpr double leastPiece = 25;                            // mm^2: what lines cut off besides is no piece
constexpr double leastFacet = 1000, leastFacetShare = 0.005; // mm^2, and of the form: what bends cut off is none
constexpr double leastWidth = 0.5;                           // mm
constexpr double leastFlatness = 0.05;                       // of edges around which a form bends
constexpr int mostDissolving = 50;                           // rounds
constexpr int mostCutsOpen = 200; // of rings; more holes than that nobody wants to sew up

class Cutter {
public:
    Cutter(WeldedForm welded, const FormCuts& cuts, const std::stop_token& stop, FormDraft* draft)
        : m_welded(std::move(welded))
        , m_cuts(cuts)
        , m_stop(stop)
        , m_draft(draft)
    {}

    Form cut()
    {
        turnAlike(m_welded, m_form.notes, m_stop);
        if (!m_draft)
            noteCrossings();
        const bool tidies = !m_cuts.lines.empty() || m_cuts.divides;
        if (tidies)
            partSheets(m_welded, m_stop);
        if (!m_cuts.edges.empty())
            m_kept = edgesAlong(m_welded, m_cuts.edges, m_cuts.onEdges);
        if (m_cuts.angle || !tidies)
            cutBends();
        if (tidies)
            cutLines();
        for (int round = 0; goesOn() && cutRingsOpen(round); ++round)
            fallApart();
        giveNames();
        if (m_stop.stop_requested() || !m_form.problem.empty())
            m_form.pieces.clear();
        m_form.points = std::move(m_welded.points);
        findRows(m_form);
        return std::move(m_form);
    }

private:
    bool goesOn() const { return !m_stop.stop_requested() && m_form.problem.empty(); }
    std::size_t count() const { return m_welded.triangles.size(); }
    int corner(int triangle, int side) const { return m_welded.triangles[triangle][side % 3]; }
    Vec3 normal(int triangle) const
    {
        const auto at = [&](int k) { return m_welded.points[corner(triangle, k)]; };
        return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    }

    void noteCrossings()
    {
        if (Message note = bodyCrossings(m_welded, m_stop).note(); !note.empty())
            m_form.notes.push_back(std::move(note));
    }

    /// Where it bends, but for facets that are too small for pieces. Before lines are cut: triangles beside these
    /// may lean anywhere.
    void cutBends()
    {
        findCuts(m_cuts.angle);
        fallApart(m_bendCuts, leastBent());
        for (const Edge& edge : m_bendCuts)
            if (m_cut.contains(edge))
                m_kept.insert(edge);
    }

    void cutLines()
    {
        if (m_stop.stop_requested())
            return;
        FormCuts cuts = m_cuts;
        cuts.angle.reset(); // that is done
        LinedTriangles lined =
            cutAlong({m_welded.points, m_welded.triangles, m_welded.part, m_kept}, cuts, m_stop, m_draft);
        if (lined.problem.empty()) {
            m_welded.points = std::move(lined.points);
            m_welded.triangles = std::move(lined.triangles);
            m_welded.part = std::move(lined.part);
            m_kept = std::move(lined.cuts);
            std::ranges::move(lined.notes, std::back_inserter(m_form.notes));
            m_form.openEnds = std::move(lined.openEnds);
        } else if (!m_cuts.lines.empty()) {
            m_form.problem = lined.problem;
            return;
        }
        findCuts(std::nullopt);
        fallApart(m_kept, leastPiece);
    }

    /// Besides those that are kept: between parts, between triangles that cannot be turned alike, and where it
    /// bends by more than so many degrees.
    void findCuts(const std::optional<double>& angle)
    {
        m_halves = halfEdges(m_welded.triangles, m_stop);
        m_cut = m_kept;
        m_flatness.clear();
        if (m_stop.stop_requested())
            return;
        const double bend = angle ? std::cos(*angle * std::numbers::pi / 180) : -2;
        eachEdge(m_halves, [&](const HalfEdge* first, const HalfEdge* last) {
            if (last - first != 2)
                return;
            const bool parts =
                m_cuts.groups && m_welded.part[first[0].triangle] != m_welded.part[first[1].triangle];
            const Edge edge{first->low, first->high};
            const bool isKept = m_kept.contains(edge);
            const double cosine =
                angle || isKept ? normal(first[0].triangle).dot(normal(first[1].triangle)) : 1; // of no account
            const bool bends = angle && cosine < bend;
            if (bends || isKept)
                m_flatness[edge] = std::max(leastFlatness, cosine);
            if (bends && !parts && !isKept)
                m_bendCuts.insert(edge);
            if (parts || bends || first[0].forward == first[1].forward)
                m_cut.insert(edge);
        });
    }

    /// Where it is cut; pieces smaller than that (mm^2) go to a neighbour across these cuts.
    void fallApart(const std::set<Edge>& cuts, double least)
    {
        fallApart();
        for (int round = 0; goesOn() && round < mostDissolving && dissolveSplinters(cuts, least); ++round)
            fallApart();
    }

    bool isWhole(const HalfEdge* first, const HalfEdge* last) const
    {
        return last - first == 2 && !m_cut.contains({first->low, first->high});
    }

    /// Vertices are corners of triangles that hang together around a point; pieces are triangles that do.
    void fallApart()
    {
        if (!goesOn())
            return;
        UnionFind corners(static_cast<int>(3 * count())), sheets(static_cast<int>(count()));
        const auto cornerAt = [&](const HalfEdge& half, int point) {
            const int side = corner(half.triangle, half.side) == point ? half.side : (half.side + 1) % 3;
            return 3 * half.triangle + side;
        };
        eachEdge(m_halves, [&](const HalfEdge* first, const HalfEdge* last) {
            if (!isWhole(first, last))
                return;
            sheets.join(first[0].triangle, first[1].triangle);
            for (const int point : {first->low, first->high})
                corners.join(cornerAt(first[0], point), cornerAt(first[1], point));
        });
        makePieces(corners, sheets);
        makeBorders();
    }

    void makePieces(UnionFind& corners, UnionFind& sheets)
    {
        m_form.pieces.clear();
        m_pieceOf.assign(count(), -1);
        m_sideOf.resize(count());
        m_parts.clear();
        std::vector<int> pieces(count(), -1), vertices(3 * count(), -1); // of the roots
        for (std::size_t t = 0; t < count(); ++t) {
            int& piece = pieces[sheets.root(static_cast<int>(t))];
            if (piece < 0) {
                piece = static_cast<int>(m_form.pieces.size());
                m_form.pieces.emplace_back();
                m_parts.push_back(m_welded.part[t]);
            }
            m_pieceOf[t] = piece;
            FormPiece& there = m_form.pieces[piece];
            Corners named{};
            for (std::size_t k = 0; k < 3; ++k) {
                int& vertex = vertices[corners.root(static_cast<int>(3 * t + k))];
                if (vertex < 0) {
                    vertex = static_cast<int>(there.points.size());
                    there.points.push_back(m_welded.triangles[t][k]);
                }
                named[k] = vertex;
            }
            m_sideOf[t] = static_cast<int>(there.triangles.size());
            there.triangles.push_back(named);
        }
    }

    /// The loops of each piece; the longest becomes its border, where the others are is kept for the rings.
    void makeBorders()
    {
        struct Side {
            int from, to;
            const HalfEdge* half;
        };
        std::vector<std::map<int, Side>> sides(m_form.pieces.size()); // by the vertex where they begin
        std::map<const HalfEdge*, const HalfEdge*> mates;
        eachEdge(m_halves, [&](const HalfEdge* first, const HalfEdge* last) {
            if (isWhole(first, last))
                return;
            if (last - first == 2 && first[0].forward != first[1].forward) {
                mates[first] = first + 1;
                mates[first + 1] = first;
            }
            for (const HalfEdge* half = first; half != last; ++half) {
                const auto piece = m_pieceOf[half->triangle];
                const Corners& named = m_form.pieces[piece].triangles[m_sideOf[half->triangle]];
                const int from = named[half->side], to = named[(half->side + 1) % 3];
                sides[piece].insert({from, {from, to, half}});
            }
        });
        std::map<const HalfEdge*, EdgeMate> places;
        std::vector<std::vector<const HalfEdge*>> borders(m_form.pieces.size());
        m_loops.assign(m_form.pieces.size(), {});
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p) {
            FormPiece& piece = m_form.pieces[p];
            std::set<int> left;
            for (const auto& [from, side] : sides[p])
                left.insert(from);
            while (!left.empty()) {
                std::vector<int> loop;
                std::vector<const HalfEdge*> along;
                for (int at = *left.begin(); left.erase(at) > 0;) {
                    const Side& side = sides[p].at(at);
                    loop.push_back(at);
                    along.push_back(side.half);
                    at = side.to;
                }
                if (loop.size() > piece.border.size()) {
                    piece.border = loop;
                    borders[p] = along;
                }
                m_loops[p].push_back(std::move(loop));
            }
            for (std::size_t k = 0; k < borders[p].size(); ++k)
                places[borders[p][k]] = {static_cast<int>(p), static_cast<int>(k)};
        }
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p) {
            m_form.pieces[p].mates.resize(borders[p].size());
            for (std::size_t k = 0; k < borders[p].size(); ++k)
                if (const auto mate = mates.find(borders[p][k]); mate != mates.end())
                    if (const auto place = places.find(mate->second); place != places.end())
                        m_form.pieces[p].mates[k] = place->second;
        }
    }

    double areaOf(const Corners& corners) const
    {
        const auto at = [&](std::size_t k) -> const Vec3& { return m_welded.points[corners[k]]; };
        return (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
    }

    bool isSplinter(const FormPiece& piece, double least) const
    {
        double area = 0, length = 0;
        const auto at = [&](int vertex) { return m_welded.points[piece.points[vertex]]; };
        for (const Corners& t : piece.triangles)
            area += areaOf({piece.points[t[0]], piece.points[t[1]], piece.points[t[2]]});
        for (std::size_t k = 0; k < piece.border.size(); ++k)
            length += (at(piece.border[piece.after(k)]) - at(piece.border[k])).norm();
        return area < std::max(least, leastWidth / 2 * length);
    }

    double leastBent() const
    {
        double area = 0;
        for (const Corners& corners : m_welded.triangles)
            area += areaOf(corners);
        return std::min(leastFacet, leastFacetShare * area);
    }

    /// Splinters between lines, borders and bends go to the neighbour that they have most in common with, rather to
    /// one in their plane than around an edge. Whether there were such, so that the form falls apart anew.
    bool dissolveSplinters(const std::set<Edge>& cuts, double least)
    {
        if (cuts.empty())
            return false;
        std::set<std::size_t> changed;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p) {
            const FormPiece& piece = m_form.pieces[p];
            if (changed.contains(p) || !isSplinter(piece, least))
                continue;
            std::map<int, std::pair<double, std::vector<Edge>>> beside; // by piece: in common, mm, and the edges
            for (std::size_t k = 0; k < piece.border.size(); ++k) {
                const int a = piece.points[piece.border[k]], b = piece.points[piece.border[piece.after(k)]];
                const Edge edge{std::min(a, b), std::max(a, b)};
                if (piece.mates[k].none() || !cuts.contains(edge))
                    continue;
                auto& [common, edges] = beside[piece.mates[k].piece];
                common += m_flatness.at(edge) * (m_welded.points[a] - m_welded.points[b]).norm();
                edges.push_back(edge);
            }
            beside.erase(static_cast<int>(p));
            const auto most =
                std::ranges::max_element(beside, {}, [](const auto& neighbour) { return neighbour.second.first; });
            if (most == beside.end())
                continue;
            for (const Edge& edge : most->second.second)
                m_cut.erase(edge);
            changed.insert({p, static_cast<std::size_t>(most->first)});
        }
        return !changed.empty();
    }

    /// Whether something was cut, so that the form falls apart anew.
    bool cutRingsOpen(int round)
    {
        bool cut = false;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p) {
            FormPiece& piece = m_form.pieces[p];
            const std::size_t loops = m_loops[p].size();
            if (loops == 0) {
                piece.refusal.key = QT_TRANSLATE_NOOP(
                    "Message",
                    "%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines");
            } else if (loops > 1 && round < mostCutsOpen) {
                openRing(p, m_loops[p]);
                cut = true;
            } else if (loops > 1) {
                piece.refusal.key = QT_TRANSLATE_NOOP(
                    "Message", "%1 is left out: it has more than %2 holes. Close them, or cut it along lines");
            } else if (eulerNumber(piece) != 1) {
                piece.refusal.key =
                    QT_TRANSLATE_NOOP("Message", "%1 is left out: it has a handle, like a cup, and cannot be laid "
                                                 "flat. Cut it along lines");
            }
        }
        return cut;
    }

    static std::ptrdiff_t eulerNumber(const FormPiece& piece)
    {
        const auto sides = 3 * std::ssize(piece.triangles);
        const auto edges = (sides + std::ssize(piece.border)) / 2;
        return std::ssize(piece.points) - edges + std::ssize(piece.triangles);
    }

    /// Along the shortest way from one loop to another one (Dijkstra).
    void openRing(std::size_t p, const std::vector<std::vector<int>>& loops)
    {
        const FormPiece& piece = m_form.pieces[p];
        std::vector<std::vector<int>> neighbours(piece.points.size());
        for (const Corners& triangle : piece.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                neighbours[triangle[k]].push_back(triangle[(k + 1) % 3]);
                neighbours[triangle[(k + 1) % 3]].push_back(triangle[k]);
            }
        std::vector<double> distance(piece.points.size(), std::numeric_limits<double>::infinity());
        std::vector<int> from(piece.points.size(), -1);
        std::vector<int> loopOf(piece.points.size(), -1);
        for (std::size_t k = 0; k < loops.size(); ++k)
            for (const int vertex : loops[k])
                loopOf[vertex] = static_cast<int>(k);
        std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
        for (const int vertex : loops.front()) {
            distance[vertex] = 0;
            queue.push({0, vertex});
        }
        const auto point = [&](int vertex) { return piece.points[vertex]; };
        const auto at = [&](int vertex) { return m_welded.points[point(vertex)]; };
        while (!queue.empty()) {
            const auto [far, vertex] = queue.top();
            queue.pop();
            if (far > distance[vertex])
                continue;
            if (loopOf[vertex] > 0) {
                for (int v = vertex; from[v] >= 0; v = from[v]) {
                    const int a = point(v), b = point(from[v]);
                    m_cut.insert({std::min(a, b), std::max(a, b)});
                    m_form.opened.push_back({a, b});
                }
                m_openings.push_back(std::ranges::find(m_pieceOf, static_cast<int>(p)) - m_pieceOf.begin());
                return;
            }
            for (const int next : neighbours[vertex]) {
                const double through = far + (at(next) - at(vertex)).norm();
                if (loopOf[next] != 0 && through < distance[next]) {
                    distance[next] = through;
                    from[next] = vertex;
                    queue.push({through, next});
                }
            }
        }
    }

    std::string nameOf(std::size_t piece) const
    {
        const std::string& name = m_welded.names[m_parts[piece]];
        return name.empty() ? "Piece" : name;
    }

    void giveNames()
    {
        std::map<std::string, int> used;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p) {
            const std::string name = nameOf(p);
            const int times = ++used[name];
            const bool numbered = times > 1 || (m_welded.names[m_parts[p]].empty() && m_form.pieces.size() > 1);
            m_form.pieces[p].name = numbered ? name + " " + std::to_string(times) : name;
            m_form.pieces[p].part = m_welded.names[m_parts[p]];
            if (!m_form.pieces[p].isSheet())
                m_form.pieces[p].refusal.args = {m_form.pieces[p].name, std::to_string(mostCutsOpen)};
        }
        const auto opened = std::ranges::count_if(
            m_openings, [&](std::ptrdiff_t triangle) { return m_form.pieces[m_pieceOf[triangle]].isSheet(); });
        if (opened > 0 && m_form.problem.empty())
            m_form.notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "Where a piece would have had a hole or been a ring it is cut "
                                              "and sewn again, number of cuts: %1"),
                 {std::to_string(opened)}});
    }

    WeldedForm m_welded;
    FormCuts m_cuts;
    std::stop_token m_stop;
    FormDraft* m_draft;
    std::vector<HalfEdge> m_halves;
    std::set<Edge> m_kept;                              // along CAD faces, bends and lines
    std::set<Edge> m_cut, m_bendCuts;                   // all; where it bends
    std::map<Edge, double> m_flatness;                  // of those that are kept, and of bends: its cosine
    std::vector<int> m_pieceOf;                         // of each triangle
    std::vector<int> m_sideOf;                          // of each triangle: its number in the piece
    std::vector<int> m_parts;                           // of each piece
    std::vector<std::vector<std::vector<int>>> m_loops; // of each piece
    std::vector<std::ptrdiff_t> m_openings;             // of rings: a triangle of each
    Form m_form;
};

} // namespace

Box3 Form::boundingBox() const
{
    Box3 box;
    for (const Vec3& point : points)
        box.extend(point);
    return box;
}

std::vector<std::array<int, 2>> bentEdges(const Form& form, const FormPiece& piece, double degrees)
{
    const auto normal = [&](int triangle) {
        const auto at = [&](int k) { return form.points[piece.points[piece.triangles[triangle][k]]]; };
        return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    };
    const double bend = std::cos(degrees * std::numbers::pi / 180);
    std::vector<std::array<int, 2>> edges;
    eachEdge(halfEdges(piece.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first == 2 && normal(first[0].triangle).dot(normal(first[1].triangle)) < bend)
            edges.push_back({first->low, first->high});
    });
    return edges;
}

static FormLine lineOf(const FixationCurve& curve)
{
    FormLine line{curve.name, {}, curve.curve.closed()};
    const std::vector<double> breaks = curve.curve.breaks();
    for (std::size_t k = 1; k < breaks.size(); ++k)
        for (int i = 0; i < samplesOfSpan; ++i)
            line.points.push_back(curve.curve.at(breaks[k - 1] + (breaks[k] - breaks[k - 1]) * i / samplesOfSpan));
    if (!line.closed)
        line.points.push_back(curve.curve.at(breaks.back()));
    return line;
}

std::vector<FormLine> linesOf(const Design& design)
{
    std::vector<FormLine> lines;
    design.each<FixationCurve>([&](ElementId, const FixationCurve& curve) { lines.push_back(lineOf(curve)); });
    return lines;
}

/// Not too many triangles.
static Form cutFewer(const TriangleMesh& mesh, const FormCuts& cuts, const std::stop_token& stop, FormDraft* draft)
{
    Form form;
    WeldedForm welded = weld(mesh, stop);
    if (stop.stop_requested())
        return {};
    if (welded.triangles.empty()) {
        form.problem = {QT_TRANSLATE_NOOP("Message", "it has no triangle with an area"), {}};
        return form;
    }
    return Cutter(std::move(welded), cuts, stop, draft).cut();
}

std::shared_ptr<FormDraft> newFormDraft()
{
    return std::make_shared<FormDraft>();
}

Form cutForm(const TriangleMesh& mesh, const FormCuts& cuts, const std::stop_token& stop, FormDraft* draft)
{
    if (mesh.triangles.size() <= mostFormTriangles)
        return cutFewer(mesh, cuts, stop, draft);
    Form form;
    const std::optional<ThinnedForm> fewer = thinForm(mesh, cuts.edges, mostFormTriangles, stop);
    if (!fewer)
        return form;
    if (fewer->mesh.triangles.size() > 2 * mostFormTriangles) { // all of them are at borders
        form.problem = {QT_TRANSLATE_NOOP("Message", "it has %1 triangles, and cannot be made simpler"),
                        {std::to_string(mesh.triangles.size())}};
        return form;
    }
    form = cutFewer(fewer->mesh, cuts, stop, draft);
    form.notes.insert(form.notes.begin(), fewer->notes.begin(), fewer->notes.end());
    return form;
}

} // namespace bolster
