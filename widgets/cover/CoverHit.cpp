#include "CoverHit.h"

#include "Selection.h"
#include "SelectionEdits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

// Pixels around the pointer.
constexpr double pointReach = 9;
constexpr double curveReach = 6;
constexpr double seamReach = 4;

struct OnSegment {
    double share = 0;    ///< from the first to the second end
    double distance = 0; ///< pixels
};

OnSegment onSegment(const Vec2& p, const Vec2& a, const Vec2& b)
{
    const double length2 = (b - a).squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0;
    return {share, (a + share * (b - a) - p).norm()};
}

/// Whether the solid that was hit stands clearly in front of the point.
bool hidden(const Camera& camera, const Vec3& point, const CoverHit& solid)
{
    return solid && camera.depth(solid.position) < camera.depth(point) - 6 - 6 * camera.pixelSize(point);
}

std::vector<Eigen::Vector3f> single(const std::vector<Vec3>& points)
{
    std::vector<Eigen::Vector3f> result;
    result.reserve(points.size());
    for (const Vec3& p : points)
        result.push_back(p.cast<float>());
    return result;
}

} // namespace

void CoverHitTest::setSurface(SurfaceMeshPtr surface)
{
    m_surface = std::move(surface);
}

const TriangleRays& CoverHitTest::rays() const
{
    if (m_raysOf == m_surface)
        return m_rays;
    if (m_raysOf && m_raysOf->topology == m_surface->topology)
        m_rays.move(single(m_surface->positions));
    else
        m_rays.build(single(m_surface->positions), m_surface->topology->triangles);
    m_raysOf = m_surface;
    return m_rays;
}

/// The ray from where it enters what is kept.
Camera::Ray CoverHitTest::keptRay(const Camera::Ray& ray) const
{
    const double climb = m_section ? m_section->normal.dot(ray.direction) : 0;
    if (!m_section || m_section->keeps(ray.origin) || climb >= 0)
        return ray;
    return {ray.origin + m_section->height(ray.origin) / climb * ray.direction, ray.direction};
}

CoverHit CoverHitTest::hitCover(const Camera::Ray& ray) const
{
    CoverHit result;
    if (!m_surface)
        return result;
    const auto hit = rays().first(ray.origin.cast<float>(), ray.direction.cast<float>());
    if (!hit)
        return result;
    result.position = ray.origin + static_cast<double>(hit->distance) * ray.direction;
    if (m_section && m_section->height(result.position) < -1e-3)
        return result;
    result.kind = CoverHit::Kind::Cover;
    result.triangle = hit->triangle;
    for (const SurfaceTopology::PatchRange& range : m_surface->topology->patches)
        if (hit->triangle - range.firstTriangle < range.triangleCount)
            result.element = range.patch;
    return result;
}

CoverHit CoverHitTest::hitFrame(const Camera::Ray& ray) const
{
    CoverHit result;
    const auto hit = m_frames.first(ray);
    if (!hit || (m_section && m_section->height(hit->position) < -1e-3))
        return result;
    result.kind = CoverHit::Kind::Frame;
    result.position = hit->position;
    result.element = hit->frame;
    result.triangle = hit->triangle;
    return result;
}

CoverHit CoverHitTest::hitSolid(const Camera& camera, QPointF pixel) const
{
    const Camera::Ray ray = keptRay(camera.ray({pixel.x(), pixel.y()}));
    const CoverHit cover = hitCover(ray);
    return cover ? cover : hitFrame(ray);
}

CoverHit CoverHitTest::hitGround(const Camera& camera, QPointF pixel) const
{
    const CoverHit frame = hitFrame(keptRay(camera.ray({pixel.x(), pixel.y()})));
    return frame ? frame : hitSolid(camera, pixel);
}

std::optional<CoverFoot> CoverHitTest::nearest(const Vec3& point, CoverHit::Kind on) const
{
    if (on == CoverHit::Kind::Frame) {
        const auto foot = m_frames.nearest(point);
        return foot ? std::optional(CoverFoot{foot->position, foot->normal}) : std::nullopt;
    }
    if (!m_surface)
        return std::nullopt;
    const auto found = rays().nearest(point.cast<float>(), std::numeric_limits<float>::max());
    if (!found)
        return std::nullopt;
    const auto& corners = m_surface->topology->triangles[found->triangle];
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    for (const std::uint32_t corner : corners)
        normal += m_surface->normals[corner];
    return CoverFoot{found->point.cast<double>(), normal.cast<double>().normalized()};
}

CoverHit CoverHitTest::hitPoint(const Question& question, const Vec2& pixel) const
{
    CoverHit best;
    double bestDistance = pointReach;
    for (const auto& [id, curve] : question.curves->all()) {
        if (!question.selection.contains(id) && question.selection.hovered() != id)
            continue;
        const std::vector<Vec3>& points = curve.spline().points();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::optional<Vec2> at = question.camera.pixel(points[i]);
            if (at && (*at - pixel).norm() < bestDistance) {
                bestDistance = (*at - pixel).norm();
                best = {CoverHit::Kind::Point, id, selectionPoint(*curve.element, static_cast<int>(i)), 0,
                        points[i]};
            }
        }
    }
    return best;
}

CoverHit CoverHitTest::hitCurve(const Question& question, const Vec2& pixel, const CoverHit& solid) const
{
    CoverHit best;
    double bestDistance = curveReach;
    for (const auto& [id, curve] : question.curves->all()) {
        const bool selected = question.selection.contains(id);
        std::optional<Vec2> last;
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const std::optional<Vec2> next = question.camera.pixel(curve.points[i]);
            if (last && next) {
                const OnSegment near = onSegment(pixel, *last, *next);
                const Vec3 at = curve.points[i - 1] + near.share * (curve.points[i] - curve.points[i - 1]);
                if (near.distance < bestDistance && (selected || !hidden(question.camera, at, solid))) {
                    bestDistance = near.distance;
                    const double t =
                        curve.parameters[i - 1] + near.share * (curve.parameters[i] - curve.parameters[i - 1]);
                    best = {CoverHit::Kind::Curve, id, -1, t, at};
                }
            }
            last = next;
        }
    }
    return best;
}

CoverHit CoverHitTest::hitSeam(const Question& question, const Vec2& pixel, const CoverHit& solid) const
{
    CoverHit best;
    double bestDistance = seamReach;
    const auto tryAlong = [&](ElementId seam, const std::vector<std::uint32_t>& vertices) {
        std::optional<Vec2> last;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Vec3& here = m_surface->positions[vertices[i]];
            const std::optional<Vec2> next = question.camera.pixel(here);
            if (last && next) {
                const OnSegment near = onSegment(pixel, *last, *next);
                const Vec3& before = m_surface->positions[vertices[i - 1]];
                const Vec3 at = before + near.share * (here - before);
                if (near.distance < bestDistance && !hidden(question.camera, at, solid)) {
                    bestDistance = near.distance;
                    best = {CoverHit::Kind::Seam, seam, -1, 0, at};
                }
            }
            last = next;
        }
    };
    for (const SurfaceTopology::Chain& chain : m_surface->topology->seams)
        tryAlong(chain.seam, chain.a);
    for (const SurfaceTopology::Line& line : m_surface->topology->lines)
        if (line.across == 0 || std::abs(line.across) == 1)
            tryAlong(line.element, line.vertices);
    return best;
}

CoverHit CoverHitTest::hit(const Question& question, QPointF position) const
{
    const Vec2 pixel(position.x(), position.y());
    if (question.curves)
        if (const CoverHit point = hitPoint(question, pixel))
            return point;
    const CoverHit solid = hitSolid(question.camera, position);
    const CoverHit cover = solid.kind == CoverHit::Kind::Cover ? solid : CoverHit{};
    if (question.curves)
        if (const CoverHit curve = hitCurve(question, pixel, cover))
            return curve;
    if (question.seams && m_surface)
        if (const CoverHit seam = hitSeam(question, pixel, cover))
            return seam;
    return solid;
}

} // namespace bolster
