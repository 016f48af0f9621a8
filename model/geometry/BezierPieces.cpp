#include "BezierPieces.h"

namespace bolster {

template <int Dim>
std::vector<BezierPiece<Dim>> bezierPieces(const BSpline<Dim>& curve)
{
    const int d = curve.degree();
    const int first = curve.closed() ? 0 : d;
    std::vector<BezierPiece<Dim>> pieces;
    for (int m = first; m < curve.pointCount(); ++m) {
        const double start = curve.m_knots[static_cast<std::size_t>(m)];
        const double end = curve.m_knots[static_cast<std::size_t>(m) + 1];
        if (start == end)
            continue;
        BezierPiece<Dim>& piece = pieces.emplace_back();
        piece.degree = d;
        piece.start = start;
        piece.end = end;
        for (int i = 0; i <= d; ++i) {
            std::array<double, 3> arguments;
            for (int k = 0; k < d; ++k)
                arguments[static_cast<std::size_t>(k)] = k < d - i ? start : end;
            piece.points[static_cast<std::size_t>(i)] = curve.blossom(m, arguments.data());
        }
    }
    return pieces;
}

template std::vector<BezierPiece<2>> bezierPieces(const BSpline<2>& curve);
template std::vector<BezierPiece<3>> bezierPieces(const BSpline<3>& curve);

} // namespace bolster
