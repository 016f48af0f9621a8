// A plain triangle mesh, for frames.
#pragma once

#include "Geometry.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bolster {

struct TriangleMesh {
    struct Part {
        std::string name;
        std::uint32_t firstTriangle = 0;
        std::uint32_t triangleCount = 0;
    };

    std::vector<Vec3> points; ///< file units
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Part> parts; ///< groups of the file; covers all triangles

    Box3 boundingBox() const
    {
        Box3 box;
        for (const Vec3& p : points)
            box.extend(p);
        return box;
    }
};

} // namespace bolster
