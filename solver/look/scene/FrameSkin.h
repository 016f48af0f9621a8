// What is seen of a frame: its mesh where it stands, pressed under the cover where that lies on it.
#pragma once

#include "Placement.h"
#include "SurfaceMesh.h"
#include "TriangleMesh.h"
#include "TriangleRays.h"

#include <array>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace bolster {

struct FrameSkin {
    struct Corner {
        Eigen::Vector3f position; ///< mm
        Eigen::Vector3f normal;   ///< unit
        Eigen::Vector3f grain;    ///< place in the material, mm; it moves with the frame, z runs along each part
    };
    Placement placement = {};    ///< of the frame when it was made
    std::vector<Corner> corners; ///< three of each triangle, counter-clockwise as in the file
};

using FrameSkinPtr = std::shared_ptr<const FrameSkin>;

/// A frame is often the outside of the foam. The cover presses that down by some millimetres or centimetres, so
/// what stands out of the cover there would hide it. Such points are put a little below the cover; everything else,
/// such as legs, stays where it is.
class FrameSkins {
public:
    /// `cover` may be null; its hidden patches press nothing.
    explicit FrameSkins(const SurfaceMesh* cover);

    /// Null when stopped.
    FrameSkinPtr skin(const TriangleMesh& mesh, const Placement& placement, const std::stop_token& stop = {}) const;

private:
    using Vec3f = Eigen::Vector3f;

    struct Foot {
        Vec3f at;     ///< on the cover
        Vec3f normal; ///< of the cover there
    };

    Vec3f pressed(const Vec3f& point, const Vec3f& outward) const;
    std::optional<Foot> footOf(const Vec3f& point, const Vec3f& outward) const;
    Vec3f normalAt(const TriangleRays::Nearest& near) const;
    bool onRim(const TriangleRays::Nearest& near) const;
    std::array<Vec3f, 3> cornersOf(std::uint32_t triangle) const;

    Eigen::AlignedBox3f m_box; ///< where it presses; empty without a cover
    TriangleRays m_rays;
    std::vector<Vec3f> m_points;                     ///< of the cover, mm
    std::vector<TriangleRays::Triangle> m_triangles; ///< of the cover, sewn: one point for those at the same place
    std::vector<Vec3f> m_faces;                      ///< unit normals of the triangles
    std::vector<Vec3f> m_normals;                    ///< and of the points
    std::vector<std::array<bool, 3>> m_rims;         ///< where the cover ends
    TriangleRays m_rim;                              ///< the same edges
    float m_depth = 0;                               ///< mm below the cover
};

} // namespace bolster
