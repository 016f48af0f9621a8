// Triangles that rays can hit: Embree behind a plain header.
#pragma once

#include "Geometry.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace bolster {

using Vec3f = Eigen::Vector3f;

struct RayHit {
    float distance = 0;
    std::uint32_t mesh = 0;        ///< by order of adding
    std::uint32_t triangle = 0;    ///< of the mesh as it was given
    float u = 0;                   ///< weight of the triangle's second corner
    float v = 0;                   ///< weight of its third corner
    Vec3f normal = Vec3f::UnitZ(); ///< of the triangle, unit, to the side from which it is counter-clockwise
};

/// Add meshes, commit once, then ask from as many threads as you like. Built on one thread: the answers are the
/// same on every run.
class RayScene {
public:
    RayScene();
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// Triangles with a point that is not finite or very far away, or with indices beyond the points, are left out.
    void add(std::span<const Vec3f> points, std::span<const std::array<std::uint32_t, 3>> triangles);
    void commit();

    /// Before anything is added: what lies beyond normal . p = offset cannot be hit.
    void cutOpen(const Vec3f& normal, float offset);

    std::optional<RayHit> first(const Vec3f& origin, const Vec3f& direction) const;
    bool blocked(const Vec3f& origin, const Vec3f& direction, float reach) const;

private:
    struct Section {
        Vec3f normal = Vec3f::UnitX();
        float offset = 0;
    };
    struct Span {
        float from = 0;
        float to = 0;
    };

    bool cutAway(std::span<const Vec3f> points, const std::array<std::uint32_t, 3>& triangle) const;
    Span kept(const Vec3f& origin, const Vec3f& direction) const;

    std::optional<Section> m_section;
    RTCDeviceTy* m_device;
    RTCSceneTy* m_scene;
    std::vector<std::vector<std::uint32_t>> m_kept; ///< per mesh: Embree's triangle -> the mesh's
};

} // namespace bolster
