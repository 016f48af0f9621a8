#include "FrameEdges.h"

#include "AssemblyImport.h"
#include "CurveFit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {
namespace {

constexpr double samePlace = 1e-4; // mm
constexpr double degree = std::numbers::pi / 180;
const double cornerTurn = std::cos(40 * degree);
constexpr double exactTolerance = 0.03; // mm; with the points' own 0.02 within 0.05 of the frame's curve
constexpr double bentTolerance = 0.25;
constexpr double longestGap = 5; // mm between samples of long curves, and
constexpr double mostGaps = 400; // so many of a longer one

/// Neighbours in the same place as one.
std::vector<Vec3> distinctPoints(const std::vector<Vec3>& points)
{
    std::vector<Vec3> distinct;
    for (const Vec3& point : points)
        if (distinct.empty() || (point - distinct.back()).norm() > samePlace)
            distinct.push_back(point);
    return distinct;
}

bool isStraight(const std::vector<Vec3>& points)
{
    const Vec3 along = (points.back() - points.front()).normalized();
    return along.allFinite() && std::ranges::all_of(points, [&](const Vec3& point) {
               const Vec3 from = point - points.front();
               return (from - from.dot(along) * along).norm() < samePlace * 10;
           });
}

/// Along the rows of points, with more of them where they lie far apart: between two samples a cubic may go
/// anywhere.
class EdgeSamples {
public:
    EdgeSamples(const std::vector<Vec3>& points, bool closed)
        : m_points(points)
        , m_count(closed ? points.size() - 1 : points.size())
    {
        m_samples.closed = closed;
        double length = 0;
        for (std::size_t i = 1; i < points.size(); ++i)
            length += (points[i] - points[i - 1]).norm();
        m_gap = std::max(longestGap, length / mostGaps);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            addSegment(i);
        if (!closed) {
            m_samples.points.push_back(points.back());
            m_samples.parameters.push_back(m_at);
        }
        m_samples.end = m_at;
        if (closed && !m_samples.corners.empty() && m_samples.corners.front() != 0)
            m_samples.corners.insert(m_samples.corners.begin(), 0);
    }

    const CurveSamples& samples() const { return m_samples; }

private:
    bool isCorner(std::size_t i) const
    {
        if (!m_samples.closed && (i == 0 || i + 1 == m_points.size()))
            return false;
        const Vec3 before = m_points[i] - m_points[(i + m_count - 1) % m_count];
        const Vec3 after = m_points[i + 1] - m_points[i];
        return before.normalized().dot(after.normalized()) < cornerTurn;
    }

    void addSegment(std::size_t i)
    {
        const Vec3 way = m_points[i + 1] - m_points[i];
        const double pieces = std::max(1.0, std::ceil(way.norm() / m_gap));
        if (isCorner(i))
            m_samples.corners.push_back(m_at);
        for (int k = 0; k < static_cast<int>(pieces); ++k) {
            m_samples.points.push_back(m_points[i] + k / pieces * way);
            m_samples.parameters.push_back(m_at + k / pieces * way.norm());
        }
        m_at += way.norm();
    }

    const std::vector<Vec3>& m_points;
    std::size_t m_count;
    CurveSamples m_samples;
    double m_gap = longestGap;
    double m_at = 0; // mm from the start
};

} // namespace

ImportedEdges importFrameEdges(const QString& path, const ImportWatch& watch)
{
    const AssemblyOrder order{coarsest, true}; // its triangles are of no use here
    const ImportedAssembly imported = importAssembly(path, watch, order);
    ImportedEdges edges{{}, imported.problem};
    if (imported.assembly)
        edges.edges = edgesOf(*imported.assembly);
    return edges;
}

std::vector<FrameEdge> edgesOf(const Assembly& assembly)
{
    std::vector<FrameEdge> edges;
    for (const Assembly::Edge& edge : assembly.edges)
        edges.push_back({edge.points, assembly.parts[edge.part].name, true});
    return edges;
}

std::optional<BSpline3> curveOnEdge(const FrameEdge& edge)
{
    std::vector<Vec3> points = distinctPoints(edge.points);
    const bool closed = edge.closed();
    if (closed && points.size() > 1)
        points.back() = points.front(); // it may have been left out as too near to its neighbour
    if (points.size() < (closed ? 4U : 2U))
        return std::nullopt;
    if (!closed && isStraight(points))
        return BSpline3(1, false, {points.front(), points.back()});
    return fitCurve(EdgeSamples(points, closed).samples(), edge.exact ? exactTolerance : bentTolerance);
}

} // namespace bolster
