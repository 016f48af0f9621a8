#include "DartClosing.h"

#include "ArcLength.h"
#include "DesignCheck.h"
#include "MouthSides.h"
#include "PiecedSpline.h"
#include "PlaneCurves.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double sameJoint = 1e-5;  // mm: between what both sides say of one place
constexpr double atMouthEnd = 1e-6; // of the mouth
constexpr double mostHandles = 1.5; // of the mouth's width: longer ones make a smooth piece bulge
constexpr double leastAhead = 0.26; // cosine: a smooth piece sets out by at most 75 degrees off the mouth's line

/// What fills a mouth: pieces of the outline, with the knots at its start, inside and at its end.
struct Filling {
    std::vector<BezierPiece<2>> pieces;
    std::vector<double> knots;
};

BezierPiece<2> bezier(std::initializer_list<Vec2> points, double from, double to)
{
    BezierPiece<2> piece;
    piece.degree = static_cast<int>(points.size()) - 1;
    piece.start = from;
    piece.end = to;
    std::ranges::copy(points, piece.points.begin());
    return piece;
}

Filling asBefore(const MouthSides& sides, const Meeting& meeting, double from, double span)
{
    Filling filling;
    const double x = meeting.at < atMouthEnd ? 0 : meeting.at > 1 - atMouthEnd ? 1 : meeting.at;
    if (x > 0)
        filling.pieces.push_back(sides.piece(false, 0, x, from, span));
    if (x < 1)
        filling.pieces.push_back(sides.piece(true, x, 1, from, span));
    filling.knots.assign(static_cast<std::size_t>(meeting.knots), from + x * span);
    return filling;
}

/// With the tangents and speeds of both sides; a quadratic one has a knot in its middle.
Filling smoothly(const MouthSides& sides, int degree, double from, double span)
{
    const double to = from + span, middle = from + span / 2;
    const Vec2 a = sides.start(), b = sides.end();
    Filling filling;
    if (degree == 3) {
        filling.pieces = {bezier({a, a + sides.startSpeed() / 3, b - sides.endSpeed() / 3, b}, from, to)};
        filling.knots = {from, from, to, to};
    } else {
        const Vec2 p = a + sides.startSpeed() / 4, q = b - sides.endSpeed() / 4, m = (p + q) / 2;
        filling.pieces = {bezier({a, p, m}, from, middle), bezier({m, q, b}, middle, to)};
        filling.knots = {from, middle, to};
    }
    return filling;
}

Filling straight(const MouthSides& sides, int degree, double from, double span)
{
    const Vec2 a = sides.start(), b = sides.end();
    BezierPiece<2> line;
    line.degree = degree;
    line.start = from;
    line.end = from + span;
    for (int i = 0; i <= degree; ++i)
        line.points[static_cast<std::size_t>(i)] = a + i * (b - a) / degree;
    Filling filling{{line}, {}};
    filling.knots.assign(static_cast<std::size_t>(degree), line.start);
    filling.knots.insert(filling.knots.end(), static_cast<std::size_t>(degree), line.end);
    return filling;
}

bool canBeSmooth(const MouthSides& sides, int degree)
{
    const Vec2 way = sides.end() - sides.start(), a = sides.startSpeed(), b = sides.endSpeed();
    const auto ahead = [&](const Vec2& speed) { return speed.dot(way) > leastAhead * speed.norm() * way.norm(); };
    return degree > 1 && ahead(a) && ahead(b) && (a.norm() + b.norm()) / 3 < mostHandles * way.norm();
}

/// An outline with a part that something else takes the place of.
class Gap {
public:
    Gap(const BSpline2& outline, double from, double to)
        : m_outline(outline)
        , m_kept(outline.part(outline.wrapped(to), outline.wrapped(from)))
        , m_pieces(bezierPieces(m_kept))
        , m_span(to - from)
        , m_sides(m_pieces.back(), m_pieces.front(), m_span)
    {}

    const MouthSides& sides() const { return m_sides; }

    /// `fill`: straight, smoothly ...
    template <class Fill>
    std::optional<BSpline2> filled(const Fill& fill) const
    {
        const Filling filling = fill(m_kept.domainEnd(), m_span);
        std::vector<BezierPiece<2>> pieces = m_pieces;
        std::vector<double> knots = innerKnots(m_kept);
        knots.insert(knots.end(), filling.knots.begin(), filling.knots.end());
        pieces.insert(pieces.end(), filling.pieces.begin(), filling.pieces.end());
        if (knots.size() < 3)
            return std::nullopt;
        const BSpline2 closed = closedSpline(pieces, std::move(knots), m_outline);
        return outlineProblem(closed) ? std::nullopt : std::optional(closed);
    }

    std::optional<BSpline2> smooth() const
    {
        const int degree = m_outline.degree();
        if (!canBeSmooth(m_sides, degree))
            return std::nullopt;
        return filled([&](double from, double span) { return smoothly(m_sides, degree, from, span); });
    }

private:
    const BSpline2& m_outline;
    BSpline2 m_kept;
    std::vector<BezierPiece<2>> m_pieces;
    double m_span;
    MouthSides m_sides;
};

/// A part that is longer on both sides by `more` (mm), but by no more than half of the way to the next corner.
std::pair<double, double> widened(const BSpline2& outline, double from, double to, double more)
{
    const ArcLength2 length(outline);
    const double period = outline.period();
    double before = from - period, after = to + period;
    for (const double corner : outline.corners())
        for (int turn = -1; turn <= 1; ++turn) {
            const double t = corner + turn * period;
            before = t < from - atMouthEnd ? std::max(before, t) : before;
            after = t > to + atMouthEnd ? std::min(after, t) : after;
        }
    const double back = std::min(more, length.between(before, from) / 2),
                 on = std::min(more, length.between(to, after) / 2);
    return {length.parameterAt(length.at(from) - back), length.parameterAt(length.at(to) + on)};
}

/// Spread, as far as the mouth is wide on both sides, no step is seen.
std::optional<BSpline2> smoothOver(const BSpline2& outline, double from, double to, bool spread)
{
    const Gap gap(outline, from, to);
    const auto [start, end] = widened(outline, from, to, (gap.sides().end() - gap.sides().start()).norm());
    const Gap wide(outline, start, end);
    std::optional<BSpline2> closed = (spread ? wide : gap).smooth();
    return closed ? closed : (spread ? gap : wide).smooth();
}

} // namespace

std::optional<BSpline2> withoutLegs(const BSpline2& outline, double from, double to, const Vec2& tip)
{
    const int degree = outline.degree();
    const Gap gap(outline, from, to);
    const MouthSides& sides = gap.sides();
    const std::optional<Meeting> meeting = sides.meeting();
    const bool turnedOpen = sides.turnedOpen(tip);
    if (meeting && (meeting->knots < degree || !turnedOpen))
        return gap.filled([&](double start, double span) { return asBefore(sides, *meeting, start, span); });
    const bool spread = turnedOpen || sides.isStep();
    if (!sides.onOneLine() && (degree > 1 || spread))
        if (auto closed = smoothOver(degree > 1 ? outline : raisedToCubic(outline), from, to, spread))
            return closed;
    return gap.filled([&](double start, double span) { return straight(sides, degree, start, span); });
}

BSpline2 withoutJoint(const BSpline2& outline, double t)
{
    const BSpline2 open = outline.part(outline.wrapped(t), outline.wrapped(t));
    const std::vector<BezierPiece<2>> pieces = bezierPieces(open);
    const BezierPiece<2>&before = pieces.back(), &after = pieces.front();
    const double span = std::min(before.end - before.start, after.end - after.start);
    const Powers a = powersAt(before, true, span / (before.end - before.start)),
                 b = powersAt(after, false, span / (after.end - after.start));
    double apart = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        apart += (b[k] - a[k]).norm();
    std::vector<double> knots = innerKnots(open);
    if (apart > sameJoint || knots.size() < 3)
        return outline;
    return closedSpline(pieces, std::move(knots), outline);
}

} // namespace bolster::edits
