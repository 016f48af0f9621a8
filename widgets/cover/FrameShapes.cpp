#include "FrameShapes.h"

#include "FramePieces.h"
#include "MeshShape.h"

#include <algorithm>
#include <limits>

namespace bolster {

FrameShapes::FrameShapes(std::function<void()> ready)
    : m_job(&FrameShapes::find, [this, ready = std::move(ready)](All found) {
        m_known = std::move(found);
        ready();
    })
{}

void FrameShapes::setFrames(const std::vector<Scene::FrameLook>& frames, const std::vector<ElementId>& ids)
{
    m_frames.clear();
    All wanted;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        m_frames.push_back({ids[i], frames[i]});
        wanted.push_back({frames[i].mesh, shapeOf(frames[i].mesh)});
    }
    if (std::ranges::all_of(wanted, [](const Known& known) { return known.shape != nullptr; })) {
        m_job.cancel();
        m_known = std::move(wanted);
    } else {
        m_job.request(std::move(wanted), true);
    }
}

FrameShapes::All FrameShapes::find(const All& wanted, std::stop_token stop)
{
    All all = wanted;
    for (auto& [mesh, known] : all) {
        if (known || !mesh || stop.stop_requested())
            continue;
        auto shape = std::make_shared<FrameShape>();
        std::vector<Eigen::Vector3f> points;
        for (const Vec3& p : mesh->points)
            points.push_back(p.cast<float>());
        shape->rays.build(std::move(points), mesh->triangles);
        shape->normals = cornerNormals(mesh->points, mesh->triangles);
        piecesOf(mesh); // so that they are known when somebody asks
        known = std::move(shape);
    }
    return all;
}

FrameShapes::ShapePtr FrameShapes::shapeOf(const std::shared_ptr<const TriangleMesh>& mesh) const
{
    const auto found = std::ranges::find(m_known, mesh, &Known::mesh);
    return found != m_known.end() ? found->shape : nullptr;
}

std::vector<FrameShapes::ShapePtr> FrameShapes::shapes() const
{
    std::vector<ShapePtr> shapes;
    for (const Placed& frame : m_frames)
        shapes.push_back(shapeOf(frame.look.mesh));
    return shapes;
}

std::optional<FrameShapes::Hit> FrameShapes::first(const Camera::Ray& ray) const
{
    std::optional<Hit> nearest;
    double distance = 0; // in lengths of the ray's direction, which placing does not change
    for (const auto& [id, look] : m_frames) {
        const ShapePtr shape = shapeOf(look.mesh);
        if (!shape)
            continue;
        const auto hit = shape->rays.first(look.placement.filePoint(ray.origin).cast<float>(),
                                           look.placement.fileDirection(ray.direction).cast<float>());
        if (!hit || (nearest && hit->distance >= distance))
            continue;
        distance = hit->distance;
        nearest = {id, ray.origin + distance * ray.direction, hit->triangle};
    }
    return nearest;
}

std::optional<FrameShapes::Foot> FrameShapes::nearest(const Vec3& point) const
{
    std::optional<Foot> best;
    double distance = std::numeric_limits<double>::max(); // mm
    for (const auto& [id, look] : m_frames) {
        const ShapePtr shape = shapeOf(look.mesh);
        if (!shape)
            continue;
        const Vec3 there = look.placement.filePoint(point);
        const auto found =
            shape->rays.nearest(there.cast<float>(), static_cast<float>(distance / look.placement.scale));
        if (!found)
            continue;
        const auto& [a, b, c] = shape->normals[found->triangle];
        const Vec3 position = look.placement.placed(found->point.cast<double>());
        distance = (position - point).norm();
        best = {position, (look.placement.rotation * (a + b + c).cast<double>()).normalized()};
    }
    return best;
}

} // namespace bolster
