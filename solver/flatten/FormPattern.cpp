#include "FormPattern.h"

#include "ArcLength.h"
#include "CurveFit.h"
#include "DesignCheck.h"
#include "EditBuilder.h"
#include "PatternSize.h"
#include "PlaneCurves.h"
#include "SeamSides.h"
#include "StretchLength.h"
#include "TwinEdits.h"
#include "UnionFind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace bolster {

namespace {

constexpr double farthestFlat = 1e6;   // mm: what lies farther out has burst when it was laid flat
constexpr double leastShape = 1e-6;    // of a triangle, against the squares of its sides
constexpr double sharpTurn = 35;       // degrees: an outline or a border that turns more has a corner
constexpr double bluntTurn = 5;        // degrees: that is seen in a straight line
constexpr double mostRounded = 2;      // mm: what a coarse form has is what it is
constexpr double besideCorner = 0.05;  // times its turn: straight
constexpr int samplesOfEdge = 4;       // for fitting
constexpr double besideEachOther = 60; // mm between patches in the layout
constexpr double rowsWide = 1.5;       // times as wide as high is what lies in rows
constexpr double mostTurned = 0.003; // of a piece's area: narrow triangles beside a cut turn over, and mean nothing
constexpr double openCut = 0.36;     // mm between the sides of a cut
constexpr double openWithin = 20;    // mm from its end on
constexpr double longerSide = 0.1;   // mm: of what opens
constexpr double fewestEdges = 4;    // across a piece: with fewer a cover has no shape to speak of
constexpr std::size_t mostNamed = 3; // pieces in a sentence
constexpr double crossing = 0.3;     // of a direction's length: less of it lies in a piece that it crosses
constexpr double unbearable = 0.5;   // strain: not even knitted fabrics
constexpr double narrowest = 0.1;    // mm: nobody sews less
constexpr double shortestCurve = 0.05; // mm: holds nothing
constexpr double leastHeld = 0.2;      // mm of border for each mm that a square of its area is wide
constexpr double sameShape = 0.5;      // mm: from each other's mirror image are twins

constexpr double bendsAlike = 3, muchLonger = 6; // times as long as the edge beside it
constexpr double mostTimes = 20;                 // as many samples as an edge of usual length has

template <class Point>
double turnAt(const Point& before, const Point& at, const Point& after)
{
    const Point in = at - before, out = after - at;
    const double both = in.norm() * out.norm();
    return both > 0 ? std::acos(std::clamp(in.dot(out) / both, -1.0, 1.0)) * 180 / std::numbers::pi : 0;
}

/// How far a curve through these places would lie from the edges between them, mm.
template <class Point>
double roundedBy(const Point& before, const Point& at, const Point& after)
{
    const double one = (at - before).norm(), other = (after - at).norm();
    const bool fromLine = std::max(one, other) > muchLonger * std::min(one, other); // which stays one
    const double length = fromLine ? std::min(one, other) : std::max(one, other);
    return length / 2 * std::tan(turnAt(before, at, after) / 4 * std::numbers::pi / 180);
}

/// Of a row; `at`: how far along its points are.
double medianEdge(const std::vector<double>& at)
{
    std::vector<double> lengths;
    for (std::size_t i = 1; i < at.size(); ++i)
        lengths.push_back(at[i] - at[i - 1]);
    const auto middle = lengths.begin() + std::ssize(lengths) / 2;
    std::ranges::nth_element(lengths, middle);
    return middle == lengths.end() ? 0 : *middle;
}

/// How far along a row its points are, mm.
template <class Point>
std::vector<double> lengthsAlong(const std::vector<Point>& row)
{
    std::vector<double> at(row.size(), 0);
    for (std::size_t i = 1; i < row.size(); ++i)
        at[i] = at[i - 1] + (row[i] - row[i - 1]).norm();
    return at;
}

/// A smooth row of points between corners, and more places on the curve through them: cubic Hermite pieces, whose
/// tangents are those of the parabolas through three neighbours. Where an edge is much longer than the other one
/// the row turns from a line into a bend: the line stays straight. `at` are the parameters of the points.
template <class Point>
CurveSamples smoothSamples(const std::vector<Point>& row, const std::vector<double>& at)
{
    const std::size_t count = row.size();
    const auto slope = [&](std::size_t i) {
        return Point((row[i + 1] - row[i]) / std::max(at[i + 1] - at[i], 1e-9));
    };
    std::vector<Point> tangents(count);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double before = at[i] - at[i - 1], after = at[i + 1] - at[i];
        const Point ofParabola = (slope(i - 1) * after + slope(i) * before) / std::max(before + after, 1e-9);
        const double times = std::max(before, after) / std::max(std::min(before, after), 1e-9);
        const double straight = std::clamp((times - bendsAlike) / (muchLonger - bendsAlike), 0.0, 1.0);
        tangents[i] = (1 - straight) * ofParabola + straight * (before > after ? slope(i - 1) : slope(i));
    }
    tangents.front() = count > 2 ? Point(2 * slope(0) - tangents[1]) : slope(0);
    tangents.back() = count > 2 ? Point(2 * slope(count - 2) - tangents[count - 2]) : slope(0);
    CurveSamples samples;
    const auto add = [&](const Point& point, double parameter) {
        Vec3 place = Vec3::Zero();
        place.template head<Point::SizeAtCompileTime>() = point;
        samples.points.push_back(place);
        samples.parameters.push_back(parameter);
    };
    const double usual = medianEdge(at);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double length = at[i + 1] - at[i];
        add(row[i], at[i]);
        const double times = usual > 0 ? std::clamp(length / usual, 1.0, mostTimes) : 1;
        const int samplesHere = static_cast<int>(samplesOfEdge * times); // between them a curve may go anywhere
        for (int k = 1; k < samplesHere; ++k) {
            const double t = static_cast<double>(k) / samplesHere;
            const double h01 = t * t * (3 - 2 * t), h10 = t * (1 - t) * (1 - t), h11 = -t * t * (1 - t);
            add((1 - h01) * row[i] + h01 * row[i + 1] + length * (h10 * tangents[i] + h11 * tangents[i + 1]),
                at[i] + t * length);
        }
    }
    add(row.back(), at.back());
    samples.end = at.back();
    return samples;
}

template <class Point>
bool isStraight(const std::vector<Point>& row, double tolerance)
{
    const Point way = row.back() - row.front();
    const double length = way.norm();
    return std::ranges::all_of(row, [&](const Point& point) {
        const Point off = point - row.front();
        const double along = length > 0 ? off.dot(way) / length : 0;
        return along >= -tolerance && along <= length + tolerance &&
               (off - along * way / std::max(length, 1e-9)).norm() <= tolerance;
    });
}

class Builder {
public:
    Builder(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
            const std::stop_token& stop)
        : m_form(form)
        , m_flat(flat)
        , m_order(order)
        , m_stop(stop)
        , m_builder(Design())
    {}

    /// Patches alone, not sewn and not held.
    const std::vector<ElementId>& addPatches()
    {
        Settings settings;
        settings.edgeLength = m_order.edgeLength;
        m_builder.replace(settingsId, settings);
        m_fabric = m_builder.add(m_order.fabric);
        m_starts.resize(m_form.pieces.size());
        m_rowWidth = rowWidth();
        findGroups();
        m_outlines.resize(m_form.pieces.size());
        m_rooms.resize(m_form.pieces.size());
        m_tolerances.resize(m_form.pieces.size(), m_order.tolerance);
        for (std::size_t p = 0; goesOn(p); ++p)
            makeCurves(p);
        makeSidesEqual(m_form, m_outlines, m_stop);
        joinCurves();
        for (std::size_t p = 0; goesOn(p); ++p)
            addPatch(p);
        return m_result.patches;
    }

    FormPattern build()
    {
        addPatches();
        for (std::size_t p = 0; goesOn(p); ++p)
            for (std::size_t r = 0; r < piece(p).rows.size(); ++r)
                addRow(p, r);
        if (m_order.twins)
            linkTwins();
        m_result.design = m_builder.now();
        if (!m_stop.stop_requested()) {
            adviseOnHolding();
            adviseOnEdges();
            adviseOnSize();
            adviseOnWidth();
            adviseOnStrain();
        }
        return std::move(m_result);
    }

private:
    bool goesOn(std::size_t p) const { return p < m_form.pieces.size() && !m_stop.stop_requested(); }
    const FormPiece& piece(std::size_t p) const { return m_form.pieces[p]; }
    const Vec3& formPoint(std::size_t p, std::size_t k) const
    {
        return m_form.points[piece(p).points[piece(p).border[k]]];
    }
    const Vec2& flatPoint(std::size_t p, std::size_t k) const { return m_flat[p].at[piece(p).border[k]]; }

    bool isCutEdge(std::size_t p, std::size_t k) const { return piece(p).mates[k].piece == static_cast<int>(p); }

    /// How far it is along the cut to where it ends inside the piece, of each place of the border; infinite where
    /// there is no such end.
    std::vector<double> distancesToTips(std::size_t p) const
    {
        const FormPiece& there = piece(p);
        const std::size_t count = there.border.size();
        std::vector<double> distances(count, std::numeric_limits<double>::infinity());
        for (std::size_t tip = 0; tip < count; ++tip)
            if (isCutEdge(p, tip) && there.mates[tip].edge == static_cast<int>(there.before(tip)))
                distances[tip] = 0; // what comes before the end of a cut is sewn to what comes after it
        const auto goAlong = [&](std::size_t edge, std::size_t from, std::size_t to) {
            if (isCutEdge(p, edge))
                distances[to] =
                    std::min(distances[to], distances[from] + (flatPoint(p, to) - flatPoint(p, from)).norm());
        };
        for (std::size_t k = 0; k < 2 * count; ++k) // twice around: a cut may go over the beginning
            goAlong(k % count, k % count, there.after(k % count));
        for (std::size_t k = 2 * count; k-- > 0;)
            goAlong(k % count, there.after(k % count), k % count);
        return distances;
    }

    /// A cut that needs no room lies edge to edge when the piece is flat, and an outline must not touch itself: its
    /// sides are drawn apart a little, less towards its end, and less where it bends, as its outer side becomes
    /// longer than the inner one.
    void openCuts(std::size_t p)
    {
        std::vector<double>& rooms = m_rooms[p];
        rooms.assign(piece(p).border.size(), openCut);
        std::vector<Vec2> moves = apartAtCuts(p, rooms);
        for (std::size_t r = 0; r < piece(p).rows.size(); ++r) {
            const BorderRow& row = piece(p).rows[r];
            if (row.matePiece != static_cast<int>(p))
                continue;
            const double longer = lengthWith(p, r, moves) - lengthWith(p, row.mateRow, moves);
            const double room = openCut * std::min(1.0, longerSide / std::max(std::abs(longer), 1e-9));
            for (std::size_t k = 0; k <= row.count; ++k) {
                double& there = rooms[(row.first + k) % rooms.size()];
                there = std::min(there, room);
            }
        }
        if (std::ranges::min(rooms) < openCut)
            moves = apartAtCuts(p, rooms);
        for (std::size_t k = 0; k < moves.size(); ++k)
            m_flat[p].at[piece(p).border[k]] += moves[k];
    }

    /// Of a row, when its places have moved; mm.
    double lengthWith(std::size_t p, std::size_t r, const std::vector<Vec2>& moves) const
    {
        const BorderRow& row = piece(p).rows[r];
        const auto at = [&](std::size_t k) {
            const std::size_t place = (row.first + k) % moves.size();
            return Vec2(flatPoint(p, place) + moves[place]);
        };
        double length = 0;
        for (std::size_t k = 0; k < row.count; ++k)
            length += (at(k + 1) - at(k)).norm();
        return length;
    }

    /// Of each place of the border, for so much room there, mm.
    std::vector<Vec2> apartAtCuts(std::size_t p, const std::vector<double>& most) const
    {
        const FormPiece& there = piece(p);
        const std::size_t count = there.border.size();
        const std::vector<double> toTip = distancesToTips(p);
        std::vector<Vec2> ways(count, Vec2::Zero()); // the sum of the directions into the piece that ask for room,
        std::vector<double> rooms(count, 0);         // and of how much each asks for
        const auto ask = [&](std::size_t k, std::size_t mate, const Vec2& inside) {
            const Vec2 apart = flatPoint(p, k) - flatPoint(p, mate);
            const double room = std::min(most[k], openCut / openWithin * toTip[k]) - apart.dot(inside);
            if (k == mate || room <= 0 || apart.norm() > 2 * openCut)
                return;
            ways[k] += inside;
            rooms[k] += room / 2;
        };
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = there.after(k);
            const Vec2 way = flatPoint(p, next) - flatPoint(p, k);
            if (!isCutEdge(p, k) || !(way.norm() > 0))
                continue;
            const Vec2 inside = Vec2(-way.y(), way.x()).normalized(); // of what runs counter-clockwise
            const auto mate = static_cast<std::size_t>(there.mates[k].edge);
            ask(k, there.after(mate), inside);
            ask(next, mate, inside);
        }
        for (std::size_t k = 0; k < count; ++k) // where two directions ask, both get it
            ways[k] *= rooms[k] / std::max(ways[k].squaredNorm(), 0.5);
        return ways;
    }

    /// Of a cut that does not open when the piece is flat.
    bool liesAtOtherSide(std::size_t p, std::size_t r) const
    {
        const BorderRow& row = piece(p).rows[r];
        const std::size_t middle = (row.first + row.count / 2) % piece(p).border.size();
        return isCutEdge(p, middle) &&
               (flatPoint(p, middle) - flatPoint(p, piece(p).after(piece(p).mates[middle].edge))).norm() <
                   2 * openCut;
    }

    bool beginsRow(std::size_t p, std::size_t k) const
    {
        return std::ranges::find(piece(p).rows, k, &BorderRow::first) != piece(p).rows.end();
    }

    double flatTurn(std::size_t p, std::size_t k) const
    {
        return turnAt(flatPoint(p, piece(p).before(k)), flatPoint(p, k), flatPoint(p, piece(p).after(k)));
    }

    /// A turn between straight lines is a corner, however blunt; in a bend the places beside it turn as well.
    bool standsAlone(std::size_t p, std::size_t k) const
    {
        const double turn = flatTurn(p, k);
        const auto isStraightAt = [&](std::size_t i) {
            const double there = flatTurn(p, i);
            return beginsRow(p, i) || there > sharpTurn || there < besideCorner * turn;
        };
        return turn > bluntTurn && isStraightAt(piece(p).before(k)) && isStraightAt(piece(p).after(k));
    }

    bool isCorner(std::size_t p, std::size_t k) const
    {
        if (beginsRow(p, k) || flatTurn(p, k) > sharpTurn || standsAlone(p, k) ||
            roundedBy(flatPoint(p, piece(p).before(k)), flatPoint(p, k), flatPoint(p, piece(p).after(k))) >
                mostRounded)
            return true;
        return piece(p).mates[k].none() && turnsOnForm(p, k);
    }

    /// Where a border goes over a crease of the form; laid flat it may be straight there.
    bool turnsOnForm(std::size_t p, std::size_t k) const
    {
        const Vec3 &before = formPoint(p, piece(p).before(k)), &at = formPoint(p, k),
                   &after = formPoint(p, piece(p).after(k));
        return turnAt(before, at, after) > sharpTurn || roundedBy(before, at, after) > mostRounded;
    }

    /// None of a piece that is left out.
    void makeCurves(std::size_t p)
    {
        if (!piece(p).isSheet()) {
            m_result.notes.push_back(piece(p).refusal);
            return;
        }
        const auto sensible = [](const Vec2& at) { return (at.array().abs() <= farthestFlat).all(); };
        if (m_flat[p].turnedShare > mostTurned || !std::ranges::all_of(m_flat[p].at, sensible)) {
            leaveOut(p);
            return;
        }
        if (widthOf(p) < narrowest) {
            m_result.notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "%1 is left out: it is too narrow to be sewn. Join "
                                              "it to what lies beside it"),
                 {piece(p).name}});
            return;
        }
        openCuts(p);
        fitCurves(p);
    }

    void fitCurves(std::size_t p)
    {
        try {
            m_outlines[p] = curvesOf(p);
        } catch (const std::invalid_argument&) { // edges without a length
            m_outlines[p] = {};
            leaveOut(p);
        }
    }

    /// An outline, and where the curves begin that it is made of.
    struct Joined {
        BSpline2 outline; ///< empty where they make none
        std::vector<double> starts;
    };

    /// The two sides of a fine tip are curves of their own, and may cross: outlines that do are fitted more
    /// closely. Then sides are made equal once more.
    void joinCurves()
    {
        constexpr int mostRefits = 2;
        constexpr double closer = 1.0 / 8;
        const auto isThere = [&](std::size_t p) { return !m_outlines[p].curves.empty(); };
        m_joined.resize(m_form.pieces.size());
        for (int round = 0;; ++round) {
            bool cross = false;
            for (std::size_t p = 0; goesOn(p); ++p) {
                if (!isThere(p))
                    continue;
                m_joined[p] = joined(m_outlines[p]);
                if (m_joined[p].outline.empty()) {
                    m_tolerances[p] *= closer;
                    cross = true;
                }
            }
            if (!cross || round == mostRefits)
                return;
            for (std::size_t p = 0; goesOn(p); ++p)
                if (isThere(p))
                    fitCurves(p);
            makeSidesEqual(m_form, m_outlines, m_stop);
        }
    }

    static Joined joined(const PieceCurves& curves)
    {
        Joined result;
        try {
            result.outline = edits::joined(curves.curves, &result.starts);
            if (outlineProblem(result.outline))
                result.outline = {};
        } catch (const std::invalid_argument&) { // edges without a length
        }
        return result;
    }

    /// Of a strip: its area by half of its border, mm.
    double widthOf(std::size_t p) const
    {
        double area = 0, length = 0;
        for (std::size_t k = 0; k < piece(p).border.size(); ++k) {
            const Vec2 here = flatPoint(p, k), next = flatPoint(p, piece(p).after(k));
            area += (here.x() * next.y() - here.y() * next.x()) / 2;
            length += (next - here).norm();
        }
        return length > 0 ? 2 * std::abs(area) / length : 0;
    }

    PieceCurves curvesOf(std::size_t p) const
    {
        const std::size_t count = piece(p).border.size(), start = piece(p).rows.front().first;
        PieceCurves outline;
        for (std::size_t k = 0; k < count;) {
            if (beginsRow(p, (start + k) % count)) {
                outline.shut.push_back(liesAtOtherSide(p, outline.rows.size()));
                outline.rows.push_back(outline.curves.size());
            }
            const bool shut = outline.shut.back();
            const std::size_t first = k;
            do
                ++k;
            while (k < count && !isCorner(p, (start + k) % count) &&
                   !(shut && isCorner(p, otherSide(p, (start + k) % count))));
            std::vector<std::size_t> places;
            for (std::size_t i = first; i <= k; ++i)
                places.push_back((start + i) % count);
            outline.curves.push_back(shut ? besideOtherSide(p, places)
                                          : curveOf(flatPoints(p, places), m_tolerances[p]));
        }
        return outline;
    }

    std::vector<Vec2> flatPoints(std::size_t p, const std::vector<std::size_t>& places) const
    {
        std::vector<Vec2> points;
        for (const std::size_t place : places)
            points.push_back(flatPoint(p, place));
        return points;
    }

    /// Across a cut: the place that was the same one. Of the end of a cut itself.
    std::size_t otherSide(std::size_t p, std::size_t k) const
    {
        return piece(p).after(static_cast<std::size_t>(piece(p).mates[k].edge));
    }

    /// One curve in the middle for both sides, which lie beside it as far as they are drawn apart: two curves of
    /// their own would cross.
    BSpline2 besideOtherSide(std::size_t p, std::vector<std::size_t> places) const
    {
        std::vector<std::size_t> others;
        for (const std::size_t place : places)
            others.push_back(otherSide(p, place));
        others.back() = static_cast<std::size_t>(piece(p).mates[piece(p).before(places.back())].edge);
        const bool isSecond = others.back() < places.front();
        if (isSecond) {
            std::ranges::reverse(places);
            std::ranges::reverse(others);
        }
        std::vector<Vec2> middle, beside;
        for (std::size_t i = 0; i < places.size(); ++i) {
            middle.push_back((flatPoint(p, places[i]) + flatPoint(p, others[i])) / 2);
            beside.push_back((flatPoint(p, places[i]) - flatPoint(p, others[i])) / 2);
        }
        BSpline2 curve = curveOf(middle, m_tolerances[p]);
        const std::vector<double> along = lengthsAlong(middle);
        const double scale = along.back() / curve.domainEnd();
        // Near its tip a cut opens within a short way, which wants a knot.
        const double opened = openWithin / openCut * m_rooms[p][places[places.size() / 2]];
        if (beside.front().isZero() && opened < along.back())
            curve = curve.withKnot(opened / scale);
        if (beside.back().isZero() && opened < along.back())
            curve = curve.withKnot((along.back() - opened) / scale);
        std::vector<Vec2> points = curve.points();
        for (int k = 0; k < curve.pointCount(); ++k)
            points[k] += between(along, beside, scale * curve.parameterOfPoint(k));
        const BSpline2 side(curve.degree(), false, std::move(points), curve.knots());
        return isSecond ? side.reversed() : side;
    }

    /// What belongs to a length along a row, of what belongs to its points.
    static Vec2 between(const std::vector<double>& along, const std::vector<Vec2>& values, double length)
    {
        const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, length);
        const auto i = static_cast<std::size_t>(after - along.begin());
        const double t = std::clamp((length - along[i - 1]) / std::max(along[i] - along[i - 1], 1e-12), 0.0, 1.0);
        return (1 - t) * values[i - 1] + t * values[i];
    }

    void addPatch(std::size_t p)
    {
        m_result.patches.push_back(noElement);
        if (m_outlines[p].curves.empty())
            return;
        Patch patch;
        patch.outline = m_joined[p].outline;
        if (patch.outline.empty()) {
            leaveOut(p);
            return;
        }
        for (const std::size_t curve : m_outlines[p].rows)
            m_starts[p].push_back(m_joined[p].starts[curve]);
        patch.name = piece(p).name;
        patch.fabric = m_fabric;
        patch.grain = grainOf(p);
        patch.position = place(patch.outline.boundingBox());
        m_result.patches.back() = m_builder.add(std::move(patch));
    }

    /// Degrees. The direction as each triangle has it, laid flat, on the average.
    double grainOf(std::size_t p) const
    {
        Vec2 sum = Vec2::Zero();
        double area = 0;
        for (const auto& corners : piece(p).triangles) {
            const auto on = [&](std::size_t k) -> const Vec3& {
                return m_form.points[piece(p).points[corners[k]]];
            };
            const auto flat = [&](std::size_t k) -> const Vec2& { return m_flat[p].at[corners[k]]; };
            Eigen::Matrix<double, 3, 2> edges;
            edges << on(1) - on(0), on(2) - on(0);
            Eigen::Matrix2d laid;
            laid << flat(1) - flat(0), flat(2) - flat(0);
            const double size = edges.col(0).cross(edges.col(1)).norm() / 2;
            if (!(size > leastShape * edges.squaredNorm())) // which way it lies is not known
                continue;
            area += size;
            sum += size * (laid * (edges.transpose() * edges).inverse() * edges.transpose() * m_order.grain.along);
        }
        if (sum.norm() <= crossing * area) // also where no direction is given
            return m_order.grain.angle;
        const double degrees = std::atan2(sum.y(), sum.x()) * 180 / std::numbers::pi;
        return std::round(10 * (degrees > 0 ? degrees : degrees + 180)) / 10; // a line has no beginning
    }

    void leaveOut(std::size_t p)
    {
        m_result.notes.push_back(
            {QT_TRANSLATE_NOOP("Message", "%1 is left out: laid flat it would lie over itself. "
                                          "Divide it, or cut it in where it bulges most"),
             {piece(p).name}});
    }

    /// Pieces that hang together, and which of these groups have a border.
    void findGroups()
    {
        const std::size_t count = m_form.pieces.size();
        UnionFind sewn(static_cast<int>(count));
        for (std::size_t p = 0; p < count; ++p)
            for (const EdgeMate& mate : piece(p).mates)
                if (!mate.none())
                    sewn.join(static_cast<int>(p), mate.piece);
        m_group = sewn.labels();
        m_open.resize(count, false);
        for (std::size_t p = 0; p < count; ++p)
            if (std::ranges::any_of(piece(p).mates, &EdgeMate::none))
                m_open[m_group[p]] = true;
    }

    bool isClosed(std::size_t p) const { return !m_open[m_group[p]]; }

    /// mm of its border that are fixed.
    double heldLength(std::size_t p) const
    {
        double length = 0;
        for (std::size_t k = 0; k < piece(p).border.size(); ++k)
            if (const EdgeMate& mate = piece(p).mates[k]; mate.none() || !isThere(mate.piece))
                length += (formPoint(p, piece(p).after(k)) - formPoint(p, k)).norm();
        return length;
    }

    void adviseOnHolding()
    {
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (isClosed(p) && isThere(p)) {
                m_result.advice.push_back(
                    {QT_TRANSLATE_NOOP("Message",
                                       "What is closed all around has no border to be held at: its cover is "
                                       "fixed along its seams. Delete the fixations of those that are to "
                                       "be free"),
                     {}});
                break;
            }
        adviseOnSmallHoles();
    }

    /// What hangs at one of them stands in no way as the form does.
    void adviseOnSmallHoles()
    {
        struct Group {
            std::string name;
            double area = 0, held = 0; // mm^2, mm
        };
        std::map<int, Group> groups;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p) {
            if (!isThere(p) || isClosed(p))
                continue;
            Group& group = groups.try_emplace(m_group[p], Group{piece(p).name}).first->second;
            group.area += areaOf(p);
            group.held += heldLength(p);
        }
        for (const auto& [number, group] : groups)
            if (group.held < leastHeld * std::sqrt(group.area))
                m_result.advice.push_back(
                    {QT_TRANSLATE_NOOP("Message", "%1, with what is sewn to it, is held only at a border of %2 mm: "
                                                  "fix it along other curves, too, or close that hole of the form"),
                     {group.name, numberText(group.held, 2)}});
    }

    /// mm, to a tenth: edges with which the smallest piece of these has a shape.
    double edgesFor(const std::vector<std::size_t>& pieces) const
    {
        double least = m_order.edgeLength;
        for (const std::size_t p : pieces)
            least = std::min(least, std::sqrt(areaOf(p)) / fewestEdges);
        return std::floor(10 * least) / 10;
    }

    double areaOf(std::size_t p) const
    {
        return std::abs(m_result.design.find<Patch>(m_result.patches[p])->outline.signedArea());
    }

    std::string namesOf(const std::vector<std::size_t>& pieces) const
    {
        std::string names;
        for (std::size_t k = 0; k < std::min(pieces.size(), mostNamed); ++k)
            names.append(k > 0 ? ", " : "").append(piece(pieces[k]).name);
        if (pieces.size() > mostNamed)
            names.append(" (+").append(std::to_string(pieces.size() - mostNamed)).append(")");
        return names;
    }

    /// Where shorter edges would make more of the cover than is convenient, they are no advice.
    void adviseOnEdges()
    {
        const double least = fewestEdges * m_order.edgeLength, all = patternArea(m_result.design);
        std::vector<std::size_t> small, specks;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (isThere(p) && areaOf(p) < least * least)
                (vertexCount(all, edgesFor({p})) > FormPattern::manyVertices ? specks : small).push_back(p);
        if (!small.empty())
            m_result.advice.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "Small for the triangles of the cover, whose edges are %1 mm long: %2. Their "
                                   "shape will be coarse; with mesh edges of %3 mm it is not"),
                 {numberText(m_order.edgeLength, 3), namesOf(small), numberText(edgesFor(small), 3)}});
        if (!specks.empty())
            m_result.advice.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join "
                                   "them to what lies beside them, or leave them out"),
                 {numberText(m_order.edgeLength, 3), namesOf(specks)}});
    }

    /// mm, across the grain.
    double breadthOf(std::size_t p) const
    {
        const double grain = m_result.design.find<Patch>(m_result.patches[p])->grain * std::numbers::pi / 180;
        const Vec2 across(-std::sin(grain), std::cos(grain));
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (std::size_t k = 0; k < piece(p).border.size(); ++k) {
            least = std::min(least, flatPoint(p, k).dot(across));
            most = std::max(most, flatPoint(p, k).dot(across));
        }
        return most - least;
    }

    void adviseOnWidth()
    {
        std::vector<std::size_t> broad;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (isThere(p) && breadthOf(p) > m_order.fabric.cutting.width)
                broad.push_back(p);
        if (!broad.empty())
            m_result.advice.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide "
                                   "them, or turn their grain"),
                 {numberText(m_order.fabric.cutting.width), namesOf(broad)}});
    }

    void adviseOnStrain()
    {
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (isThere(p) && m_flat[p].strainP99 > unbearable)
                m_result.advice.push_back(
                    {QT_TRANSLATE_NOOP("Message", "%1 is strained by %2 % when it lies on the form, more than any "
                                                  "fabric bears. Divide it, or cut it in where it bulges most"),
                     {piece(p).name, numberText(100 * m_flat[p].strainP99, 2)}});
    }

    /// Such as of a file whose numbers are millimetres and were taken for metres.
    void adviseOnSize()
    {
        const double least = smallestEdgeLength(m_result.design);
        if (m_order.edgeLength >= least)
            return;
        Box3 box;
        for (const Vec3& point : m_form.points)
            box.extend(point);
        m_result.advice.push_back(
            {QT_TRANSLATE_NOOP("Message",
                               "The form is %1 mm large: with edges of %2 mm its cover has more triangles "
                               "than can be solved. See whether the unit is right; else make the mesh "
                               "edges at least %3 mm long"),
             {numberText(box.sizes().maxCoeff(), 3), numberText(m_order.edgeLength, 3),
              numberText(std::ceil(least), 6)}});
    }

    static BSpline2 curveOf(const std::vector<Vec2>& row, double tolerance)
    {
        if (isStraight(row, tolerance / 4))
            return edits::polyline({row.front(), row.back()}, 3, 0, 1);
        const BSpline3 fitted = fitCurve(smoothSamples(row, lengthsAlong(row)), tolerance);
        std::vector<Vec2> points;
        for (const Vec3& point : fitted.points())
            points.emplace_back(point.head<2>());
        return {fitted.degree(), false, std::move(points), fitted.knots()};
    }

    double rowWidth() const
    {
        double area = 0;
        for (const FlatPiece& flat : m_flat) {
            Box2 box;
            for (const Vec2& at : flat.at)
                box.extend(at);
            area += (box.sizes().x() + besideEachOther) * (box.sizes().y() + besideEachOther);
        }
        return rowsWide * std::sqrt(area);
    }

    /// Side by side, in rows from above to below.
    Vec2 place(const Box2& box)
    {
        if (m_cursor.x() > 0 && m_cursor.x() + box.sizes().x() > m_rowWidth) {
            m_cursor = {0, m_cursor.y() - m_rowHeight - besideEachOther};
            m_rowHeight = 0;
        }
        const Vec2 at(m_cursor.x() - box.min().x(), m_cursor.y() - box.max().y());
        m_cursor.x() += box.sizes().x() + besideEachOther;
        m_rowHeight = std::max(m_rowHeight, box.sizes().y());
        return at;
    }

    bool isThere(std::size_t p) const { return m_result.patches[p] != noElement; }

    Stretch stretchOf(std::size_t p, std::size_t r) const
    {
        return {m_result.patches[p], m_starts[p][r], m_starts[p][r + 1 < m_starts[p].size() ? r + 1 : 0]};
    }

    void addRow(std::size_t p, std::size_t r)
    {
        const BorderRow& row = piece(p).rows[r];
        if (!isThere(p))
            return;
        if (!row.isSewn())
            addFixation(p, row, r);
        else if (!isThere(row.matePiece)) // it is left out, as a hole of the form
            addFixation(p, row, r);
        else if (std::pair(row.matePiece, row.mateRow) >= std::pair(static_cast<int>(p), static_cast<int>(r))) {
            addSeam(p, row, r);
            if (isClosed(p))
                addFixation(p, row, r);
        }
    }

    void addSeam(std::size_t p, const BorderRow& row, std::size_t r)
    {
        Seam seam;
        seam.a = stretchOf(p, r);
        seam.b = stretchOf(row.matePiece, row.mateRow);
        // Of a piece with itself, as a tube's, the solver rounds a plain seam by itself, and finds the tube from
        // farther away.
        const bool rounded = row.matePiece != static_cast<int>(p) && bendAlong(p, row) < m_order.hardEdge;
        seam.continuity = rounded ? Continuity::G1 : Continuity::C0;
        const double a = lengthOf(p, seam.a), b = lengthOf(row.matePiece, seam.b);
        m_result.seams.push_back({m_builder.add(seam), a, b});
    }

    double lengthOf(std::size_t p, const Stretch& stretch) const
    {
        const BSpline2& outline = m_builder.now().find<Patch>(m_result.patches[p])->outline;
        const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
        return ArcLength2(outline).between(stretch.from, end);
    }

    /// The angle by which the form bends across a row, on average; degrees.
    double bendAlong(std::size_t p, const BorderRow& row) const
    {
        double sum = 0, length = 0;
        for (std::size_t k = 0; k < row.count; ++k) {
            const std::size_t edge = (row.first + k) % piece(p).border.size();
            const EdgeMate& mate = piece(p).mates[edge];
            const double weight = (formPoint(p, piece(p).after(edge)) - formPoint(p, edge)).norm();
            const Vec3 here = normalBeside(p, edge), there = normalBeside(mate.piece, mate.edge);
            sum += weight * std::acos(std::clamp(here.dot(there), -1.0, 1.0)) * 180 / std::numbers::pi;
            length += weight;
        }
        return length > 0 ? sum / length : 0;
    }

    Vec3 normalBeside(std::size_t p, std::size_t edge) const
    {
        const int from = piece(p).border[edge], to = piece(p).border[piece(p).after(edge)];
        const auto point = [&](int v) { return m_form.points[piece(p).points[v]]; };
        for (const auto& triangle : trianglesAt(p, from))
            for (int k = 0; k < 3; ++k)
                if (triangle[k] == from && triangle[(k + 1) % 3] == to)
                    return (point(to) - point(from)).cross(point(triangle[(k + 2) % 3]) - point(from)).normalized();
        return Vec3::UnitZ();
    }

    /// Those around a vertex; made for a piece when it is first asked for.
    std::vector<std::array<int, 3>> trianglesAt(std::size_t p, int vertex) const
    {
        m_around.resize(m_form.pieces.size());
        auto& around = m_around[p];
        if (around.empty()) {
            around.resize(piece(p).points.size());
            for (const auto& triangle : piece(p).triangles)
                for (const int corner : triangle)
                    around[corner].push_back(triangle);
        }
        return around[vertex];
    }

    /// The parameters of the curve are those of the outline, so that each point of the cloth is held where it lies
    /// on the form, also where the cloth is strained along its border.
    void addFixation(std::size_t p, const BorderRow& row, std::size_t r)
    {
        CurveSamples samples;
        std::vector<Vec3> smooth{formPoint(p, row.first)};
        std::vector<Vec2> laid{flatPoint(p, row.first)};
        double at = 0;
        for (std::size_t k = 1; k <= row.count; ++k) {
            const std::size_t index = (row.first + k) % piece(p).border.size();
            smooth.push_back(formPoint(p, index));
            laid.push_back(flatPoint(p, index));
            if (k < row.count && !isCorner(p, index) && !turnsOnForm(p, index))
                continue;
            const CurveSamples part = smoothSamples(smooth, lengthsAlong(laid));
            if (at > 0)
                samples.corners.push_back(at);
            for (std::size_t i = at > 0 ? 1 : 0; i < part.points.size(); ++i) {
                samples.points.push_back(part.points[i]);
                samples.parameters.push_back(at + part.parameters[i]);
            }
            at += part.end;
            smooth = {formPoint(p, index)};
            laid = {flatPoint(p, index)};
        }
        samples.end = at;
        if (lengthsAlong(samples.points).back() < shortestCurve)
            return;
        FixationCurve curve;
        curve.name = m_names.free(piece(p).name);
        curve.curve = fitCurve(samples, m_order.tolerance);
        FixationSeam fixation;
        fixation.stretch = stretchOf(p, r);
        fixation.match = slipOf(p, row) > m_order.tolerance ? Match::Parameter : Match::Length;
        fixation.curve = m_builder.add(std::move(curve));
        m_builder.add(fixation);
    }

    /// How far a point of the row would be held off its place if lengths alone counted, mm.
    double slipOf(std::size_t p, const BorderRow& row) const
    {
        std::vector<Vec3> onForm;
        std::vector<Vec2> laid;
        for (std::size_t k = 0; k <= row.count; ++k) {
            const std::size_t index = (row.first + k) % piece(p).border.size();
            onForm.push_back(formPoint(p, index));
            laid.push_back(flatPoint(p, index));
        }
        const std::vector<double> there = lengthsAlong(onForm), here = lengthsAlong(laid);
        const double scale = there.back() / std::max(here.back(), 1e-9);
        double most = 0;
        for (std::size_t k = 0; k < there.size(); ++k)
            most = std::max(most, std::abs(here[k] * scale - there[k]));
        return most;
    }

    /// Whether the border of one piece, mirrored at x = 0, lies on that of the other one.
    bool mirrors(std::size_t p, std::size_t q) const
    {
        for (std::size_t k = 0; k < piece(p).border.size(); ++k) {
            const Vec3 here = formPoint(p, k).cwiseProduct(Vec3(-1, 1, 1));
            double nearest = 2 * sameShape;
            for (std::size_t i = 0; i < piece(q).border.size() && nearest > sameShape; ++i) {
                const Vec3 from = formPoint(q, i), way = formPoint(q, piece(q).after(i)) - from;
                const double along = std::clamp((here - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (from + along * way - here).norm());
            }
            if (nearest > sameShape)
                return false;
        }
        return true;
    }

    /// Pieces that are mirror images of each other at the usual plane of symmetry follow each other from now on.
    void linkTwins()
    {
        for (std::size_t p = 0; goesOn(p); ++p)
            for (std::size_t q = p + 1; goesOn(q); ++q) {
                if (!isThere(p) || !isThere(q) || !mirrors(p, q) || !mirrors(q, p))
                    continue;
                const Edit link = edits::linkTwins(m_builder.now(), m_result.patches[p], m_result.patches[q]);
                if (link.empty())
                    continue;
                const Design linked = m_builder.now().with(link);
                if (checkedWell(linked) && keepsLengths(m_builder.now(), linked))
                    m_builder.apply(link);
            }
    }

    /// A follower gets other corners; with those of very short edges ends of seams could come to lie at wrong ones.
    static bool keepsLengths(const Design& before, const Design& after)
    {
        bool kept = true;
        const auto compare = [&](const Stretch& was, const Stretch& is) {
            kept = kept && std::abs(stretchLength(after, is) - stretchLength(before, was)) <= 2 * sameShape;
        };
        before.each<Seam>([&](ElementId id, const Seam& seam) {
            if (const auto* now = after.find<Seam>(id)) {
                compare(seam.a, now->a);
                compare(seam.b, now->b);
            }
        });
        before.each<FixationSeam>([&](ElementId id, const FixationSeam& seam) {
            if (const auto* now = after.find<FixationSeam>(id))
                compare(seam.stretch, now->stretch);
        });
        return kept;
    }

    static bool checkedWell(const Design& design) { return !hasErrors(checkDesign(design)); }

    const Form& m_form;
    std::vector<FlatPiece> m_flat;
    const FormPatternOrder& m_order;
    std::stop_token m_stop;
    edits::EditBuilder m_builder;
    edits::Names<FixationCurve> m_names{Design()};
    FormPattern m_result;
    ElementId m_fabric = noElement;
    std::vector<int> m_group;                  // of each piece: the one that it hangs together with
    std::vector<bool> m_open;                  // of each group: it has a border
    std::vector<PieceCurves> m_outlines;       // of each piece
    std::vector<Joined> m_joined;              // of each piece
    std::vector<double> m_tolerances;          // of each piece's outline, mm
    std::vector<std::vector<double>> m_rooms;  // of each place of its border: how far a cut there may open, mm
    std::vector<std::vector<double>> m_starts; // of each piece: where its rows begin on the outline
    mutable std::vector<std::vector<std::vector<std::array<int, 3>>>> m_around;
    Vec2 m_cursor = Vec2::Zero();
    double m_rowHeight = 0;
    double m_rowWidth = 0;
};

} // namespace

FormPattern formPattern(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
                        const std::stop_token& stop)
{
    return Builder(form, flat, order, stop).build();
}

std::vector<bool> becomePatches(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
                                const std::stop_token& stop)
{
    std::vector<bool> become;
    Builder builder(form, flat, order, stop);
    for (const ElementId patch : builder.addPatches())
        become.push_back(patch != noElement);
    become.resize(form.pieces.size(), false); // when stopped
    return become;
}

} // namespace bolster
