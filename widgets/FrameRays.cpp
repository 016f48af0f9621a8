#include "FrameRays.h"

#include <algorithm>

namespace bolster {

FrameRays::FrameRays()
    : m_job(&FrameRays::build, [this](Trees trees) { m_trees = std::move(trees); })
{}

void FrameRays::setFrames(const std::vector<SurfaceScene::FrameLook>& frames, const std::vector<ElementId>& ids)
{
    m_frames.clear();
    Trees wanted;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        m_frames.push_back({ids[i], frames[i]});
        const auto known = std::ranges::find(m_trees, frames[i].mesh, &Tree::mesh);
        wanted.push_back(known != m_trees.end() ? *known : Tree{frames[i].mesh, nullptr});
    }
    if (std::ranges::all_of(wanted, [](const Tree& tree) { return tree.rays != nullptr; })) {
        m_job.cancel();
        m_trees = std::move(wanted);
    } else {
        m_job.request(std::move(wanted), true);
    }
}

FrameRays::Trees FrameRays::build(const Trees& wanted, std::stop_token stop)
{
    Trees trees = wanted;
    for (Tree& tree : trees) {
        if (tree.rays || !tree.mesh || stop.stop_requested())
            continue;
        auto rays = std::make_shared<SurfaceRays>();
        std::vector<Eigen::Vector3f> points;
        for (const Vec3& p : tree.mesh->points)
            points.push_back(p.cast<float>());
        rays->build(std::move(points), tree.mesh->triangles);
        tree.rays = std::move(rays);
    }
    return trees;
}

const SurfaceRays* FrameRays::raysOf(const MeshPtr& mesh) const
{
    const auto found = std::ranges::find(m_trees, mesh, &Tree::mesh);
    return found != m_trees.end() ? found->rays.get() : nullptr;
}

std::optional<FrameRays::Hit> FrameRays::first(const Camera::Ray& ray) const
{
    std::optional<Hit> nearest;
    double distance = 0; // in lengths of the ray's direction, which placing does not change
    for (const auto& [id, look] : m_frames) {
        const SurfaceRays* rays = raysOf(look.mesh);
        if (!rays)
            continue;
        const auto hit = rays->first(look.placement.filePoint(ray.origin).cast<float>(),
                                     look.placement.fileDirection(ray.direction).cast<float>());
        if (!hit || (nearest && hit->distance >= distance))
            continue;
        distance = hit->distance;
        nearest = {id, ray.origin + distance * ray.direction};
    }
    return nearest;
}

} // namespace bolster
