#include "OutlineSamples.h"

#include "BezierPieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double leastJump = 0.5 * std::numbers::pi / 180; // of a tangent, to be a corner
constexpr int mostHalvings = 14;

double angleBetween(const Vec2& a, const Vec2& b)
{
    return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// The direction at an end of a piece, also where control points coincide.
Vec2 direction(const BezierPiece<2>& piece, bool atEnd)
{
    const auto last = static_cast<std::size_t>(piece.degree);
    const Vec2& from = atEnd ? piece.back() : piece.front();
    for (std::size_t k = 1; k <= last; ++k) {
        const Vec2 step = atEnd ? Vec2(from - piece.points[last - k]) : Vec2(piece.points[k] - from);
        if (step.norm() > 1e-9)
            return step.normalized();
    }
    return Vec2::Zero();
}

class Sampler {
public:
    explicit Sampler(const SampleOrder& order)
        : m_order(order)
    {}

    void piece(const BezierPiece<2>& piece, int depth = 0)
    {
        if (depth < mostHalvings && piece.degree > 1 && !isFlat(piece)) {
            for (const BezierPiece<2>& half : piece.halves())
                this->piece(half, depth + 1);
            return;
        }
        m_result.push_back({piece.front(), piece.start, false});
    }

    std::vector<OutlineSample> result() { return std::move(m_result); }

private:
    /// Half of each tolerance: the offset's samples are off by that much, too.
    bool isFlat(const BezierPiece<2>& piece) const
    {
        const Vec2 chord = piece.back() - piece.front();
        double off = 0;
        for (int k = 1; k < piece.degree; ++k) {
            const Vec2 arm = piece.points[static_cast<std::size_t>(k)] - piece.front();
            off = std::max(off, chord.norm() > 1e-12
                                    ? std::abs(chord.x() * arm.y() - chord.y() * arm.x()) / chord.norm()
                                    : arm.norm());
        }
        const double turn = angleBetween(direction(piece, false), direction(piece, true));
        return off <= m_order.chord / 2 && m_order.reach * turn * turn / 8 <= m_order.chord / 2;
    }

    const SampleOrder& m_order;
    std::vector<OutlineSample> m_result;
};

/// The pieces, cut where there shall be a sample.
std::vector<BezierPiece<2>> brokenPieces(const BSpline2& curve, const std::vector<double>& breaks)
{
    const double slack = 1e-9 * curve.period();
    std::vector<double> wanted;
    for (const double t : breaks)
        wanted.push_back(curve.wrapped(t));
    std::ranges::sort(wanted);
    std::vector<BezierPiece<2>> result;
    for (BezierPiece<2> piece : bezierPieces(curve)) {
        for (const double t : wanted) {
            if (t <= piece.start + slack || t >= piece.end - slack)
                continue;
            const BSpline2 part = curve.part(piece.start, t), rest = curve.part(t, piece.end);
            result.push_back(bezierPieces(part).front());
            result.back().start = piece.start;
            result.back().end = t;
            const double end = piece.end;
            piece = bezierPieces(rest).front();
            piece.start = t;
            piece.end = end;
        }
        result.push_back(piece);
    }
    return result;
}

} // namespace

std::vector<OutlineSample> sampled(const BSpline2& curve, const SampleOrder& order)
{
    if (curve.empty())
        return {};
    const std::vector<BezierPiece<2>> pieces = brokenPieces(curve, order.breaks);
    Sampler sampler(order);
    std::vector<std::size_t> starts;
    std::vector<OutlineSample> result;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Sampler one(order);
        one.piece(pieces[i]);
        std::vector<OutlineSample> samples = one.result();
        const BezierPiece<2>& before = pieces[(i + pieces.size() - 1) % pieces.size()];
        samples.front().corner = (i == 0 && !curve.closed()) ||
                                 angleBetween(direction(before, true), direction(pieces[i], false)) > leastJump;
        for (OutlineSample& sample : samples)
            if (result.empty() || (sample.at - result.back().at).norm() > 1e-9)
                result.push_back(sample);
            else
                result.back().corner = result.back().corner || sample.corner;
    }
    if (!curve.closed())
        result.push_back({pieces.back().back(), curve.domainEnd(), true});
    else if (result.size() > 1 && (result.front().at - result.back().at).norm() <= 1e-9)
        result.pop_back();
    return result;
}

} // namespace bolster
