// Finds the triangle that a ray meets, or that is nearest to a point: a tree of boxes that follows moving points.
#pragma once

#include "Geometry.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
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
    struct Node {
        Eigen::Array3f low = Eigen::Array3f::Zero();
        Eigen::Array3f high = Eigen::Array3f::Zero();
        std::uint32_t first =
            0; ///< triangle in the tree's order, or the right child; the left one follows its parent
        std::uint32_t count = 0; ///< triangles; 0: an inner node
    };

    std::uint32_t split(std::uint32_t first, std::uint32_t count, std::vector<Eigen::Array3f>& centres);
    void fitBox(Node& node) const;
    void fitBoxes();
    float approach(const Vec3f& origin, const Vec3f& direction) const;
    class Entry;
    template <class Distance, class Visit>
    void walk(const Distance& distance, const float& reach, const Visit& visit) const;

    std::vector<Vec3f> m_points;
    std::vector<Triangle> m_triangles; ///< in the tree's order
    std::vector<std::uint32_t> m_ids;  ///< of those triangles, as they were given
    std::vector<Node> m_nodes;
};

} // namespace bolster
