#include "DartClosing.h"

#include "BezierPieces.h"
#include "DesignCheck.h"
#include "PiecedSpline.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double samePoint = 1e-5;  // mm: between what both sides say of one place
constexpr double sameShare = 1e-6;  // of the mouth
constexpr double onOneLine = 1e-6;  // radians
constexpr double mostHandles = 1.5; // of the mouth's width: longer ones make a smooth piece bulge
constexpr double leastAhead = 0.26; // cosine: a smooth piece sets out by at most 75 degrees off the mouth's line

/// Of one side, c0 + c1 x + ..., x from 0 to 1 over the mouth.
using Powers = std::array<Vec2, 4>;

Vec2 valueAt(const Powers& powers, double x)
{
    return powers[0] + x * (powers[1] + x * (powers[2] + x * powers[3]));
}

Vec2 speedAt(const Powers& powers, double x)
{
    return powers[1] + x * (2 * powers[2] + 3 * x * powers[3]);
}

double choose(int n, int k)
{
    double result = 1;
    for (int i = 0; i < k; ++i)
        result = result * (n - i) / (i + 1);
    return result;
}

/// About one end of a piece, in a unit of `scale` times its length.
Powers powersAt(const BezierPiece<2>& piece, bool end, double scale)
{
    const int d = piece.degree;
    Powers powers{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    for (int k = 0; k <= d; ++k) {
        Vec2 difference = Vec2::Zero();
        for (int i = 0; i <= k; ++i)
            difference += ((k - i) % 2 == 0 ? 1 : -1) * choose(k, i) *
                          piece.points[static_cast<std::size_t>(end ? d - k + i : i)];
        powers[static_cast<std::size_t>(k)] = choose(d, k) * std::pow(scale, k) * difference;
    }
    return powers;
}

/// The same polynomial, in x + 1 where it was in x.
Powers oneBefore(const Powers& powers)
{
    Powers moved{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    for (std::size_t k = 0; k < powers.size(); ++k)
        for (std::size_t j = 0; j <= k; ++j)
            moved[j] += choose(static_cast<int>(k), static_cast<int>(j)) * ((k - j) % 2 == 0 ? 1 : -1) * powers[k];
    return moved;
}

double largest(const Powers& powers)
{
    double sum = 0;
    for (const Vec2& power : powers)
        sum += power.norm();
    return sum;
}

/// Where two sides meet, and how many knots belong there.
struct Meeting {
    double at = 0; ///< of the mouth, 0 to 1
    int knots = 0;
};

/// The outline on both sides of a mouth, as polynomials that go on over it.
class MouthSides {
public:
    MouthSides(const BezierPiece<2>& before, const BezierPiece<2>& after, double span)
        : m_degree(before.degree)
        , m_before(powersAt(before, true, span / (before.end - before.start)))
        , m_after(oneBefore(powersAt(after, false, span / (after.end - after.start))))
    {
        for (std::size_t k = 0; k < m_between.size(); ++k)
            m_between[k] = m_after[k] - m_before[k];
    }

    std::optional<Meeting> meeting() const
    {
        if (largest(m_between) < samePoint)
            return Meeting{0.5, 0};
        const std::optional<Meeting> smooth = smoothMeeting(), found = smooth ? smooth : cornerMeeting();
        return found && (found->knots < m_degree || isCornerAt(found->at)) ? found : std::nullopt;
    }

    /// From x0 to x1, as a piece of the curve's parameter.
    BezierPiece<2> piece(bool after, double x0, double x1, double from, double span) const
    {
        const Powers& powers = after ? m_after : m_before;
        BezierPiece<2> piece;
        piece.degree = m_degree;
        piece.start = from + x0 * span;
        piece.end = from + x1 * span;
        Powers moved{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()}; // in u = (x - x0) / (x1 - x0)
        for (std::size_t k = 0; k < powers.size(); ++k)
            for (std::size_t j = 0; j <= k; ++j)
                moved[j] += choose(static_cast<int>(k), static_cast<int>(j)) *
                            std::pow(x0, static_cast<double>(k - j)) * std::pow(x1 - x0, static_cast<double>(j)) *
                            powers[k];
        for (int i = 0; i <= m_degree; ++i) {
            Vec2& point = piece.points[static_cast<std::size_t>(i)];
            point = Vec2::Zero();
            for (int j = 0; j <= i; ++j)
                point += choose(i, j) / choose(m_degree, j) * moved[static_cast<std::size_t>(j)];
        }
        return piece;
    }

    Vec2 start() const { return m_before[0]; }
    Vec2 end() const { return valueAt(m_after, 1); }
    Vec2 startSpeed() const { return m_before[1]; }
    Vec2 endSpeed() const { return speedAt(m_after, 1); }

private:
    /// Both sides on one line make none, however fast they run.
    bool isCornerAt(double x) const
    {
        const Vec2 a = speedAt(m_before, x), b = speedAt(m_after, x);
        return std::abs(cross(a, b)) > onOneLine * a.norm() * b.norm() || a.dot(b) < 0;
    }

    /// One simple knot: what is between the sides is a power of the distance from it.
    std::optional<Meeting> smoothMeeting() const
    {
        const auto d = static_cast<std::size_t>(m_degree);
        const Vec2& c = m_between[d];
        if (!(c.norm() > 0))
            return std::nullopt;
        const double at = -m_between[d - 1].dot(c) / (m_degree * c.squaredNorm());
        Powers rest = m_between;
        for (std::size_t k = 0; k <= d; ++k)
            rest[k] -= choose(m_degree, static_cast<int>(k)) * std::pow(-at, static_cast<double>(d - k)) * c;
        if (largest(rest) > samePoint || at < -sameShare || at > 1 + sameShare)
            return std::nullopt;
        return Meeting{std::clamp(at, 0.0, 1.0), 1};
    }

    /// They only cross.
    std::optional<Meeting> cornerMeeting() const
    {
        for (const double end : {0.0, 1.0})
            if (valueAt(m_between, end).norm() < samePoint)
                return Meeting{end, m_degree};
        constexpr int samples = 64;
        const Vec2 along = valueAt(m_between, 1) - valueAt(m_between, 0);
        const auto ahead = [&](double x) { return valueAt(m_between, x).dot(along); };
        for (int k = 0; k < samples; ++k) {
            double low = static_cast<double>(k) / samples, high = static_cast<double>(k + 1) / samples;
            if ((ahead(low) < 0) == (ahead(high) < 0))
                continue;
            for (int step = 0; step < 50; ++step) {
                const double middle = (low + high) / 2;
                ((ahead(middle) < 0) == (ahead(low) < 0) ? low : high) = middle;
            }
            if (valueAt(m_between, low).norm() < samePoint)
                return Meeting{low, m_degree};
        }
        return std::nullopt;
    }

    int m_degree;
    Powers m_before;
    Powers m_after;
    Powers m_between; ///< from the one before to the one after
};

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
    const double x = meeting.at < sameShare ? 0 : meeting.at > 1 - sameShare ? 1 : meeting.at;
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

Filling fillingOf(const MouthSides& sides, int degree, double from, double span)
{
    if (const std::optional<Meeting> meeting = sides.meeting())
        return asBefore(sides, *meeting, from, span);
    return canBeSmooth(sides, degree) ? smoothly(sides, degree, from, span) : straight(sides, degree, from, span);
}

} // namespace

std::optional<BSpline2> withoutLegs(const BSpline2& outline, double from, double to)
{
    const BSpline2 kept = outline.part(outline.wrapped(to), outline.wrapped(from));
    const double span = to - from, start = kept.domainEnd(); // of the mouth
    std::vector<BezierPiece<2>> pieces = bezierPieces(kept);
    const MouthSides sides(pieces.back(), pieces.front(), span);
    const Filling filling = fillingOf(sides, outline.degree(), start, span);
    std::vector<double> knots = innerKnots(kept);
    knots.insert(knots.end(), filling.knots.begin(), filling.knots.end());
    pieces.insert(pieces.end(), filling.pieces.begin(), filling.pieces.end());
    if (knots.size() < 3)
        return std::nullopt;
    const BSpline2 closed = closedSpline(pieces, std::move(knots), outline);
    return outlineProblem(closed) ? std::nullopt : std::optional(closed);
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
    if (apart > samePoint || knots.size() < 3)
        return outline;
    return closedSpline(pieces, std::move(knots), outline);
}

} // namespace bolster::edits
