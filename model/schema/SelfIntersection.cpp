// Where an outline crosses or touches itself.
//
// The curve is cut into chunks that turn little. Two chunks that do not follow each other are compared by the
// distance of their chords and subdivided while the curves may still meet; so near neighbours that run parallel
// cost little and are never mistaken for crossings. Two chunks that follow each other meet in their common point,
// of course. They meet nowhere else if the cones of their tangents, seen from there, are apart: that holds for
// smooth curves and for every corner with a positive angle, once the chunks are short enough.
#include "DesignCheck.h"

#include "BezierPieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double smallTurn = 0.35;     // radians, either side of a chunk's middle direction
constexpr double foldedBack = 1e-4;    // radians; a corner with less folds back on itself
constexpr double touchingShare = 1e-7; // of the outline's size: what is closer touches

double angleBetween(const Vec2& a, const Vec2& b)
{
    return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

struct Chunk {
    BezierPiece<2> piece;
    Box2 box;
    Vec2 direction = Vec2::Zero();    // of the middle tangent, unit
    double spread = std::numbers::pi; // the tangents lie within this angle of it
    double flatness = 0;              // no point is farther from the chord, mm
    double length = 0;                // of the control polygon, mm

    explicit Chunk(const BezierPiece<2>& p)
        : piece(p)
    {
        std::array<Vec2, 3> edges;
        const auto degree = static_cast<std::size_t>(p.degree);
        box.extend(p.front());
        for (std::size_t i = 0; i < degree; ++i) {
            edges[i] = p.points[i + 1] - p.points[i];
            length += edges[i].norm();
            direction += edges[i].normalized(); // Eigen leaves a zero vector as it is
            box.extend(p.points[i + 1]);
        }
        if (!(direction.norm() > 1e-9))
            return;
        direction.normalize();
        spread = 0;
        for (std::size_t i = 0; i < degree; ++i)
            if (edges[i].squaredNorm() > 0)
                spread = std::max(spread, angleBetween(direction, edges[i]));
        for (std::size_t i = 1; i < degree; ++i)
            flatness = std::max(flatness, distanceToChord(p.points[i]));
    }

    Vec2 nearestOnChord(const Vec2& point) const
    {
        const Vec2 chord = piece.back() - piece.front();
        const double squared = chord.squaredNorm();
        const double u = squared > 0 ? std::clamp((point - piece.front()).dot(chord) / squared, 0.0, 1.0) : 0;
        return piece.front() + u * chord;
    }
    double distanceToChord(const Vec2& point) const { return (point - nearestOnChord(point)).norm(); }

    std::array<Chunk, 2> halves() const
    {
        const auto parts = piece.halves();
        return {Chunk(parts[0]), Chunk(parts[1])};
    }
};

struct Approach {
    double distance = 0;
    Vec2 point = Vec2::Zero();
};

// Of the chords of two chunks.
Approach approach(const Chunk& a, const Chunk& b)
{
    const Vec2 u = a.piece.back() - a.piece.front();
    const Vec2 v = b.piece.back() - b.piece.front();
    const Vec2 w = b.piece.front() - a.piece.front();
    const double cross = u.x() * v.y() - u.y() * v.x();
    if (cross != 0) {
        const double s = (w.x() * v.y() - w.y() * v.x()) / cross;
        const double t = (w.x() * u.y() - w.y() * u.x()) / cross;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
            return {0, a.piece.front() + s * u};
    }
    Approach best{std::numeric_limits<double>::infinity(), Vec2::Zero()};
    const auto offer = [&](const Vec2& end, const Chunk& other) {
        const double distance = other.distanceToChord(end);
        if (distance < best.distance)
            best = {distance, end};
    };
    offer(a.piece.front(), b);
    offer(a.piece.back(), b);
    offer(b.piece.front(), a);
    offer(b.piece.back(), a);
    return best;
}

class Search {
public:
    explicit Search(const BSpline2& outline)
    {
        m_tolerance = touchingShare * outline.boundingBox().diagonal().norm();
        for (const BezierPiece<2>& piece : bezierPieces(outline))
            add(Chunk(piece));
        while (!m_chunks.empty() && m_chunks.size() < 4) { // so that two chunks meet at one end at most
            const std::vector<Chunk> whole = std::move(m_chunks);
            m_chunks.clear();
            for (const Chunk& chunk : whole)
                for (const Chunk& half : chunk.halves())
                    m_chunks.push_back(half);
        }
    }

    std::optional<Vec2> run() const
    {
        for (std::size_t i = 0; i < m_chunks.size(); ++i)
            if (const auto found = meetBeyondJoint(m_chunks[i], m_chunks[(i + 1) % m_chunks.size()]))
                return found;

        // Sweep along x: compare with the chunks whose boxes are still open.
        std::vector<std::size_t> order(m_chunks.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return m_chunks[a].box.min().x() < m_chunks[b].box.min().x();
        });
        std::vector<std::size_t> open;
        for (const std::size_t i : order) {
            const double left = m_chunks[i].box.min().x() - m_tolerance;
            std::erase_if(open, [&](std::size_t j) { return m_chunks[j].box.max().x() < left; });
            for (const std::size_t j : open)
                if (!neighbours(i, j))
                    if (const auto found = meet(m_chunks[i], m_chunks[j]))
                        return found;
            open.push_back(i);
        }
        return std::nullopt;
    }

private:
    // Chunks too short to matter are left out: their neighbours count as following each other.
    void add(const Chunk& chunk)
    {
        if (chunk.length <= 4 * m_tolerance)
            return;
        if (chunk.spread <= smallTurn) {
            m_chunks.push_back(chunk);
            return;
        }
        for (const Chunk& half : chunk.halves())
            add(half);
    }

    bool neighbours(std::size_t i, std::size_t j) const
    {
        const std::size_t apart = i > j ? i - j : j - i;
        return apart == 1 || apart + 1 == m_chunks.size();
    }

    std::optional<Vec2> meet(const Chunk& a, const Chunk& b) const
    {
        if (a.box.exteriorDistance(b.box) > m_tolerance)
            return std::nullopt;
        const Approach chords = approach(a, b);
        if (chords.distance > a.flatness + b.flatness + m_tolerance)
            return std::nullopt;
        if (a.flatness + b.flatness <= m_tolerance)
            return chords.point;
        const bool splitA = a.flatness >= b.flatness;
        for (const Chunk& half : (splitA ? a : b).halves())
            if (const auto found = meet(half, splitA ? b : a))
                return found;
        return std::nullopt;
    }

    // Where a and the chunk b that follows it meet, apart from their joint.
    std::optional<Vec2> meetBeyondJoint(const Chunk& a, const Chunk& b) const
    {
        const double angle = angleBetween(-a.direction, b.direction);
        const double spread = a.spread + b.spread;
        if (angle > std::max(spread, foldedBack))
            return std::nullopt;
        if (spread < foldedBack || a.length + b.length < 8 * m_tolerance)
            return b.piece.front();
        const auto [a0, a1] = a.halves();
        const auto [b0, b1] = b.halves();
        for (const auto& [x, y] : {std::pair(&a0, &b0), std::pair(&a0, &b1), std::pair(&a1, &b1)})
            if (const auto found = meet(*x, *y))
                return found;
        return meetBeyondJoint(a1, b0);
    }

    double m_tolerance = 0;
    std::vector<Chunk> m_chunks; // in the order of the curve
};

} // namespace

std::optional<Vec2> selfIntersection(const BSpline2& outline)
{
    return Search(outline).run();
}

} // namespace bolster
