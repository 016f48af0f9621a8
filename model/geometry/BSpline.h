// B-spline curves of degree 1 to 3 in 2D (outlines) and 3D (fixation curves). A polygon is degree 1.
#pragma once

#include "Geometry.h"
#include "Message.h"

#include <array>
#include <optional>
#include <vector>

namespace bolster {

template <int Dim>
struct BezierPiece;

/// More control points than anybody can handle; designs with more in one curve are refused.
inline constexpr int mostCurvePoints = 10'000;

/// An immutable curve, open or closed, with non-uniform knots. Points are millimetres.
///
/// Open: n points, n + d + 1 clamped knots; the domain is [knots[d], knots[n]].
/// Closed: the first point is not repeated; n + 1 knots k_0..k_n with period k_n - k_0, continued periodically.
/// With a = floor((d + 1) / 2), basis i has the support k_(i-a)..k_(i-a+d+1). The domain is [k_0, k_n].
/// A corner is a knot of multiplicity d (for degree 1 every knot is one).
template <int Dim>
class BSpline {
public:
    using Point = Eigen::Matrix<double, Dim, 1>;
    using Box = Eigen::AlignedBox<double, Dim>;

    struct Closest {
        double parameter = 0;
        Point point = Point::Zero();
        double distance = 0;
    };

    /// What is wrong with such a curve, if anything: degree, number of points, knots. Empty `knots` means the
    /// default ones. Coordinates must be finite and within +-1e7.
    static std::optional<Message> problem(int degree, bool closed, const std::vector<Point>& points,
                                          const std::vector<double>& knots = {});
    /// The same for the `corners` of a closed cubic.
    static std::optional<Message> cornerProblem(int degree, bool closed, int pointCount,
                                                const std::vector<int>& corners);

    /// An empty curve, only good for being assigned to.
    BSpline() = default;
    /// Throws std::invalid_argument when `problem` has something to say. Empty `knots`: uniform ones,
    /// 0 to n - d (open) or 0 to n (closed).
    BSpline(int degree, bool closed, std::vector<Point> points, std::vector<double> knots = {});
    /// A closed cubic that interpolates its points `corners` (increasing indices): corner i has the triple knot
    /// t = i, the other knots lie evenly between two corners.
    static BSpline withCorners(std::vector<Point> points, const std::vector<int>& corners);

    bool empty() const { return m_points.empty(); }
    int degree() const { return m_degree; }
    bool closed() const { return m_closed; }
    int pointCount() const { return static_cast<int>(m_points.size()); }
    const std::vector<Point>& points() const { return m_points; }
    const std::vector<double>& knots() const { return m_knots; }
    bool hasDefaultKnots() const;
    /// The corner indices when the knots are exactly those that `withCorners` gives; else nothing.
    std::optional<std::vector<int>> cornerIndices() const;

    double domainStart() const;
    double domainEnd() const;
    double period() const { return domainEnd() - domainStart(); }
    /// Closed: into [start, end). Open: clamped to the domain.
    double wrapped(double t) const;

    Point at(double t) const;
    /// A control point and its share of a place.
    struct Influence {
        int point = 0;
        double share = 0;
    };
    /// The control points that at(t) is a mean of; the shares are not negative and their sum is 1. A point may be
    /// listed twice on a closed curve of few points.
    std::vector<Influence> influencesAt(double t) const;
    /// Derivative of the given order (1 or more) with respect to the parameter; at a knot from the right.
    Point derivative(double t, int order = 1) const;
    /// Distinct knots in the domain, ends included: between two of them the curve is one polynomial.
    std::vector<double> breaks() const;
    /// Parameters in [start, end) where the tangent may jump: knots of multiplicity >= degree inside, and on a
    /// closed curve the start if it is one. The ends of an open curve are not listed.
    std::vector<double> corners() const;
    /// The parameter at which control point i has most influence (Greville abscissa), wrapped into the domain.
    double parameterOfPoint(int i) const;
    /// The control point that has most influence next to a parameter of the domain; -1 for an empty curve.
    int pointAt(double t) const;

    Box boundingBox() const;
    /// Signed area inside a closed 2D curve: positive when it runs counter-clockwise. 0 for open or 3D curves.
    double signedArea() const;
    /// Closest point of the whole curve, to within 1e-9 of the curve's size.
    Closest closest(const Point& p) const;

    /// The same curve with point i moved to p.
    BSpline withPoint(int i, const Point& p) const;
    BSpline withPoints(std::vector<Point> points) const;
    /// Knot insertion: the same shape with one more control point; every parameter stays valid.
    /// Returns *this when t already has multiplicity d.
    BSpline withKnot(double t) const;
    /// One control point less, with the least change of shape (least squares in the control points). Corners and
    /// the ends of an open curve stay where they are, unless the point itself is a corner: that becomes smoother.
    /// The period stays; only when the knot at the start of a closed curve goes does the domain begin at the
    /// next knot, every parameter keeping its place. Nothing when too few points would remain, or when the point
    /// only shapes the curve between two corners or ends that have no others between them.
    std::optional<BSpline> withoutPoint(int i) const;
    /// The open part from t0 to t1 (closed curves: passing the start if t1 <= t0), parameters kept up to
    /// a period.
    BSpline part(double t0, double t1) const;
    /// The same shape walked backwards; parameter t becomes start + end - t.
    BSpline reversed() const;

    friend bool operator==(const BSpline& a, const BSpline& b)
    {
        return a.m_degree == b.m_degree && a.m_closed == b.m_closed && a.m_points == b.m_points &&
               a.m_knots == b.m_knots;
    }

private:
    template <int D>
    friend std::vector<BezierPiece<D>> bezierPieces(const BSpline<D>& curve);

    int shift() const { return m_closed ? (m_degree + 1) / 2 : 0; }
    int pointIndex(int basis) const;
    double knot(int index) const;
    double nearestKnot(double t) const;
    BSpline startingAtKnot(int index) const;
    BSpline withoutKnot(double place, int removed, double& change) const;
    int spanAt(double t) const;
    int multiplicity(double knotValue) const;
    std::array<Point, 4> localPoints(int span) const;
    Point blossom(int span, const double* arguments) const;
    template <class Value>
    Value blossom(int span, const double* arguments, std::array<Value, 4> values) const;

    // Basis j has the support u_j..u_(j+d+1) of the knots u, which knot() continues periodically on a closed curve;
    // it belongs to point j + shift().
    int m_degree = 1;
    bool m_closed = false;
    std::vector<Point> m_points;
    std::vector<double> m_knots;
};

using BSpline2 = BSpline<2>;
using BSpline3 = BSpline<3>;

extern template class BSpline<2>;
extern template class BSpline<3>;

} // namespace bolster
