// What must be known about the meshes of frames: how they are hit, and how light falls on them.
#pragma once

#include "Camera.h"
#include "LatestJob.h"
#include "TriangleRays.h"
#include "ViewScene.h"

#include <functional>
#include <memory>
#include <vector>

namespace bolster {

/// In the coordinates of the file, so that a frame can be moved for nothing.
struct FrameShape {
    TriangleRays rays;
    std::vector<std::array<Eigen::Vector3f, 3>> normals; ///< of each triangle's corners
};

/// Finds them beside the GUI thread, once for each mesh.
class FrameShapes {
public:
    using ShapePtr = std::shared_ptr<const FrameShape>;

    struct Hit {
        ElementId frame{};
        Vec3 position = Vec3::Zero(); ///< mm
        std::uint32_t triangle = 0;   ///< of its mesh
    };

    struct Foot {
        Vec3 position = Vec3::Zero(); ///< mm
        Vec3 normal = Vec3::UnitZ();  ///< unit
    };

    /// `ready` is called when there is something new.
    explicit FrameShapes(std::function<void()> ready);

    void setFrames(const std::vector<Scene::FrameLook>& frames, const std::vector<ElementId>& ids);
    /// For each frame; null until it is known.
    std::vector<ShapePtr> shapes() const;
    /// The nearest hit of the frames whose shape is known.
    std::optional<Hit> first(const Camera::Ray& ray) const;
    /// The place that is nearest to a point, mm, likewise.
    std::optional<Foot> nearest(const Vec3& point) const;

private:
    struct Known {
        std::shared_ptr<const TriangleMesh> mesh;
        ShapePtr shape; ///< null while it is being found
    };
    using All = std::vector<Known>;
    struct Placed {
        ElementId id{};
        Scene::FrameLook look;
    };

    static All find(const All& wanted, std::stop_token stop);
    ShapePtr shapeOf(const std::shared_ptr<const TriangleMesh>& mesh) const;

    std::vector<Placed> m_frames;
    All m_known;
    LatestJob<All, All> m_job;
};

} // namespace bolster
