// Which triangle of a form is nearest to a place.
#pragma once

#include "BoxTree.h"
#include "Geometry.h"

namespace bolster {

class FormTree {
public:
    using Triangle = BoxTree<double>::Triangle;

    struct Nearest {
        Vec3 at = Vec3::Zero();
        std::uint32_t triangle = 0;
    };

    /// Of at least one, mm. When stopped it means nothing.
    explicit FormTree(std::vector<Triangle> triangles, const std::stop_token& stop = {});

    Nearest nearestTo(const Vec3& place) const;
    const Triangle& triangle(std::uint32_t number) const { return m_triangles[number]; }

private:
    std::vector<Triangle> m_triangles;
    BoxTree<double> m_boxes;
};

} // namespace bolster
