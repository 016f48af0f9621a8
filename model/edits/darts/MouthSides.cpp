#include "MouthSides.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double samePoint = 1e-5;     // mm: between what both sides say of one place
constexpr double sameShare = 1e-6;     // of the mouth
constexpr double oneDirection = 1e-6;  // radians
constexpr double seenAsStep = 0.05;    // radians
constexpr double sameLegs = 0.05;      // mm: legs that nobody could tell apart
constexpr double turnedExactly = 1e-3; // radians

double angleBetween(const Vec2& a, const Vec2& b)
{
    return std::atan2(cross(a, b), a.dot(b));
}

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

} // namespace

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

MouthSides::MouthSides(const BezierPiece<2>& before, const BezierPiece<2>& after, double span)
    : m_degree(before.degree)
    , m_before(powersAt(before, true, span / (before.end - before.start)))
    , m_after(oneBefore(powersAt(after, false, span / (after.end - after.start))))
{
    for (std::size_t k = 0; k < m_between.size(); ++k)
        m_between[k] = m_after[k] - m_before[k];
}

std::optional<Meeting> MouthSides::meeting() const
{
    if (largest(m_between) < samePoint)
        return Meeting{0.5, 0};
    const std::optional<Meeting> smooth = smoothMeeting(), found = smooth ? smooth : cornerMeeting();
    return found && (found->knots < m_degree || isCornerAt(found->at)) ? found : std::nullopt;
}

bool MouthSides::turnedOpen(const Vec2& tip) const
{
    const Vec2 a = start() - tip, b = end() - tip;
    if (std::abs(a.norm() - b.norm()) > sameLegs)
        return false;
    const Vec2 onwards = Eigen::Rotation2Dd(angleBetween(a, b)) * startSpeed();
    return std::abs(angleBetween(onwards, endSpeed())) < turnedExactly;
}

bool MouthSides::onOneLine() const
{
    const Vec2 way = end() - start();
    return std::abs(angleBetween(startSpeed(), way)) < oneDirection &&
           std::abs(angleBetween(way, endSpeed())) < oneDirection;
}

bool MouthSides::isStep() const
{
    const Vec2 way = end() - start();
    const double into = angleBetween(startSpeed(), way), out = angleBetween(way, endSpeed());
    return into * out < 0 && std::min(std::abs(into), std::abs(out)) > seenAsStep;
}

BezierPiece<2> MouthSides::piece(bool after, double x0, double x1, double from, double span) const
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

Vec2 MouthSides::end() const
{
    return valueAt(m_after, 1);
}

Vec2 MouthSides::endSpeed() const
{
    return speedAt(m_after, 1);
}

/// Both sides on one line make none, however fast they run.
bool MouthSides::isCornerAt(double x) const
{
    const Vec2 a = speedAt(m_before, x), b = speedAt(m_after, x);
    return std::abs(cross(a, b)) > oneDirection * a.norm() * b.norm() || a.dot(b) < 0;
}

/// One simple knot: what is between the sides is a power of the distance from it.
std::optional<Meeting> MouthSides::smoothMeeting() const
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
std::optional<Meeting> MouthSides::cornerMeeting() const
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

} // namespace bolster::edits
