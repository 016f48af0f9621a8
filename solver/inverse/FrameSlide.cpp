#include "FrameSlide.h"

#include "NearestOnTriangle.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double liesOn = 2; // mm: curves that were drawn on a frame bridge what is hollow between their points
constexpr double controlReach = 200; // mm: control points of a curve that lies on it
constexpr double leastStep = 5;      // mm
constexpr int samples = 32;

} // namespace

FrameSurface::FrameSurface(const Frame& frame, const TriangleMesh& mesh, const Box3& within)
{
    std::vector<Eigen::Vector3f> points;
    for (const Vec3& point : mesh.points) {
        m_points.push_back(frame.placed(point));
        points.push_back(m_points.back().cast<float>());
    }
    for (const auto& triangle : mesh.triangles) {
        Box3 box;
        for (const std::uint32_t corner : triangle)
            box.extend(m_points[corner]);
        if (box.intersects(within))
            m_triangles.push_back(triangle);
    }
    m_tree.build(std::move(points), m_triangles);
}

std::optional<FrameSurface::Place> FrameSurface::nearest(const Vec3& point, double reach) const
{
    const auto found = m_tree.nearest(point.cast<float>(), static_cast<float>(reach));
    if (!found)
        return std::nullopt;
    const auto& [i, j, k] = m_triangles[found->triangle];
    const Vec3 &a = m_points[i], &b = m_points[j], &c = m_points[k];
    return Place{nearestOnTriangle(point, a, b, c), (b - a).cross(c - a).normalized()};
}

std::shared_ptr<const FrameSlide> FrameSlide::of(const BSpline3& curve, std::shared_ptr<const FrameSurface> frame)
{
    for (int k = 0; k <= samples; ++k)
        if (!frame->nearest(curve.at(curve.domainStart() + curve.period() * k / samples), liesOn))
            return nullptr;
    auto slide = std::shared_ptr<FrameSlide>(new FrameSlide);
    for (int k = 0; k < curve.pointCount(); ++k) {
        const double t = curve.parameterOfPoint(k), share = (t - curve.domainStart()) / curve.period();
        const Vec3 on = curve.at(t);
        const auto foot = frame->nearest(curve.points()[static_cast<std::size_t>(k)], controlReach);
        const auto below = frame->nearest(on, controlReach);
        if (!foot || !below)
            return nullptr;
        Vec3 way = below->normal.cross(curve.derivative(t)).normalized();
        if (!(way.norm() > 0.5)) // a triangle without area, or points that lie on each other
            way = slide->m_points.empty() ? Vec3::Zero() : slide->m_points.back().way;
        slide->m_points.push_back({curve.points()[static_cast<std::size_t>(k)], *foot, way, 2 * share - 1});
    }
    slide->m_frame = std::move(frame);
    return slide;
}

/// In small steps, each in the plane of the frame where the last one has led. Over a sharp edge it does not go.
Vec3 FrameSlide::walked(const Point& point, double way) const
{
    const int steps = static_cast<int>(std::ceil(std::abs(way) / leastStep));
    FrameSurface::Place foot = point.foot;
    Vec3 direction = point.way;
    for (int step = 0; step < steps; ++step) {
        const auto next = m_frame->nearest(foot.point + way / steps * direction, std::abs(way) + 1);
        if (!next)
            break;
        foot = *next;
        const Vec3 flat = direction - direction.dot(foot.normal) * foot.normal;
        if (flat.norm() > 0)
            direction = flat.normalized();
    }
    return foot.point + (point.at - point.foot.point);
}

std::vector<Vec3> FrameSlide::places(double sideways, double turned) const
{
    std::vector<Vec3> places;
    for (const Point& point : m_points)
        places.push_back(walked(point, sideways + point.turn * turned));
    return places;
}

} // namespace bolster
