#include "ArcLength.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Length of a piece from u0 to u1 by Gauss-Legendre quadrature of order 8.
template <int Dim>
double quadrature(const BezierPiece<Dim>& piece, double u0, double u1)
{
    static constexpr std::array<double, 4> node = {0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                                   0.96028985649753623};
    static constexpr std::array<double, 4> weight = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                                     0.10122853629037626};
    const double middle = (u0 + u1) / 2;
    const double half = (u1 - u0) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < node.size(); ++i)
        sum += weight[i] * (piece.derivative(middle - half * node[i]).norm() +
                            piece.derivative(middle + half * node[i]).norm());
    return half * sum;
}

// Appends the piece, in halves where its quadrature is not accurate to `tolerance` (mm) yet.
template <int Dim>
void appendAccurate(const BezierPiece<Dim>& piece, double tolerance, int depth,
                    std::vector<BezierPiece<Dim>>& pieces, std::vector<double>& lengths)
{
    const double whole = quadrature(piece, 0, 1);
    const double inHalves = quadrature(piece, 0, 0.5) + quadrature(piece, 0.5, 1);
    if (std::abs(whole - inHalves) <= tolerance || depth == 0) {
        pieces.push_back(piece);
        lengths.push_back(lengths.back() + inHalves);
        return;
    }
    for (const BezierPiece<Dim>& half : piece.halves())
        appendAccurate(half, tolerance, depth - 1, pieces, lengths);
}

template <int Dim>
double controlPolygonLength(const std::vector<BezierPiece<Dim>>& pieces)
{
    double length = 0;
    for (const BezierPiece<Dim>& piece : pieces)
        for (std::size_t i = 0; i < static_cast<std::size_t>(piece.degree); ++i)
            length += (piece.points[i + 1] - piece.points[i]).norm();
    return length;
}

} // namespace

template <int Dim>
ArcLength<Dim>::ArcLength(const BSpline<Dim>& curve)
    : m_closed(curve.closed())
    , m_lengths{0}
{
    const std::vector<BezierPiece<Dim>> spans = bezierPieces(curve);
    const double tolerance = 1e-10 * controlPolygonLength(spans);
    for (const BezierPiece<Dim>& span : spans)
        appendAccurate(span, tolerance, 20, m_pieces, m_lengths);
}

template <int Dim>
double ArcLength<Dim>::at(double t) const
{
    const double start = m_pieces.front().start;
    const double end = m_pieces.back().end;
    const double turns = m_closed ? std::floor((t - start) / (end - start)) : 0;
    const double inside = std::clamp(t - turns * (end - start), start, end);
    const auto above = std::upper_bound(m_pieces.begin() + 1, m_pieces.end(), inside,
                                        [](double value, const auto& piece) { return value < piece.start; });
    const BezierPiece<Dim>& piece = *(above - 1);
    const double before = m_lengths[static_cast<std::size_t>(above - 1 - m_pieces.begin())];
    const double u = (inside - piece.start) / (piece.end - piece.start);
    return turns * total() + before + (u > 0 ? quadrature(piece, 0, u) : 0);
}

template <int Dim>
double ArcLength<Dim>::parameterAt(double s) const
{
    const double start = m_pieces.front().start;
    const double end = m_pieces.back().end;
    if (!(total() > 0))
        return start;
    const double turns = m_closed ? std::floor(s / total()) : 0;
    const double inside = std::clamp(s - turns * total(), 0.0, total());
    const auto above = std::upper_bound(m_lengths.begin() + 1, m_lengths.end() - 1, inside);
    const auto index = static_cast<std::size_t>(above - 1 - m_lengths.begin());
    const BezierPiece<Dim>& piece = m_pieces[index];
    const double length = m_lengths[index + 1] - m_lengths[index];
    const double target = inside - m_lengths[index];

    // Newton, kept inside a bracket that halves when it would leave it.
    double low = 0;
    double high = 1;
    double u = length > 0 ? std::clamp(target / length, 0.0, 1.0) : 0;
    for (int i = 0; i < 60 && length > 0; ++i) {
        const double excess = quadrature(piece, 0, u) - target;
        (excess > 0 ? high : low) = u;
        if (std::abs(excess) <= 1e-14 * total() || high - low < 1e-15)
            break;
        const double next = u - excess / piece.derivative(u).norm();
        u = next > low && next < high ? next : (low + high) / 2;
    }
    return turns * (end - start) + piece.parameter(u);
}

template class ArcLength<2>;
template class ArcLength<3>;

Vec3 placeAlong(std::span<const Vec3> row, double share)
{
    double length = 0;
    for (std::size_t k = 1; k < row.size(); ++k)
        length += (row[k] - row[k - 1]).norm();
    double left = share * length;
    for (std::size_t k = 1; k < row.size(); ++k) {
        const double piece = (row[k] - row[k - 1]).norm();
        if (left <= piece && piece > 0)
            return row[k - 1] + left / piece * (row[k] - row[k - 1]);
        left -= piece;
    }
    return row.back();
}

} // namespace bolster
