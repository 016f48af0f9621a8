// Finds the triangle that a ray meets, or that is nearest to a point: a tree of boxes that follows moving points.
#pragma once

#include "BoxTree.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace bolster {

/// Single precision, lengths in mm. Triangles with points that are not finite are never hit.
class TriangleRays {
public:
    using Vec3f = Eigen::Vector3f;
    using Triangle = std::array<std::uint32_t, 3>;

    struct Hit {
        std::uint32_t triangle = 0;
        float distance = 0; ///< in lengths of the direction
    };

    struct Nearest {
        std::uint32_t triangle = 0;
        Vec3f point = Vec3f::Zero(); ///< on it
    };

    void build(std::vector<Vec3f> points, std::vector<Triangle> triangles);
    /// The same triangles with moved points: much cheaper.
    void move(std::vector<Vec3f> points);

    std::optional<Hit> first(const Vec3f& origin, const Vec3f& direction) const;
    /// Nothing when no triangle is nearer than `reach`.
    std::optional<Nearest> nearest(const Vec3f& point, float reach) const;
    bool blocked(const Vec3f& origin, const Vec3f& direction, float reach) const;

private:
    using Boxes = BoxTree<float>;

    class Entry;
    Boxes::Triangle cornersOf(const Triangle& triangle) const;
    Boxes::Triangle cornersAt(std::uint32_t place) const { return cornersOf(m_triangles[place]); }
    float approach(const Vec3f& origin, const Vec3f& direction) const;

    std::vector<Vec3f> m_points;
    std::vector<Triangle> m_triangles; ///< in the tree's order
    Boxes m_boxes;
};

} // namespace bolster
