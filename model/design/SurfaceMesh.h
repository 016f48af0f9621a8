// What the solver publishes: the cover as a plain value.
#pragma once

#include "ElementId.h"
#include "Geometry.h"
#include "Seam.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace bolster {

/// What stays the same while only positions move. Vertices belong to one patch each: along a seam every patch has
/// its own, so textures end at the seam.
struct SurfaceTopology {
    struct PatchRange {
        ElementId patch{};
        ElementId fabric{};
        std::uint32_t firstVertex = 0;
        std::uint32_t vertexCount = 0;
        std::uint32_t firstTriangle = 0;
        std::uint32_t triangleCount = 0;
        std::uint32_t outlineCount = 0; ///< the first vertices are the outline, in its order
    };
    /// The vertices along a stretch, in the order of the stretch `a`; `b` is empty for fixation seams.
    /// Vertex a[k] is sewn to b[k].
    struct Chain {
        ElementId seam{}; ///< of a Seam or FixationSeam
        std::vector<std::uint32_t> a;
        std::vector<std::uint32_t> b;
        Continuity continuity = Continuity::C0; ///< of the seam: where it is not C0 the surface has no crease
    };

    /// The vertices along a handle curve or one of the parallel lines of a fancy seam. A closed one ends where it
    /// begins.
    struct Line {
        ElementId element{};
        std::vector<std::uint32_t> vertices;
        double across = 0;   ///< of a fancy seam: -1 and 1 are the outer lines, 0 the middle
        bool crease = false; ///< the surface is folded along it
    };

    std::uint64_t serial =
        0; ///< within one run of the program; the same for those that differ in `pattern` and creases alone
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise seen from the outside
    std::vector<Vec2> pattern;          ///< outline coordinates of each vertex, mm: the texture coordinates
    std::vector<std::uint32_t> unknown; ///< merged vertex of each vertex: equal for sewn ones
    std::uint32_t unknownCount = 0;
    std::vector<PatchRange> patches; ///< by increasing patch id
    std::vector<Chain> seams;
    std::vector<Chain> fixations;
    std::vector<Line> lines; ///< patch by patch

    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(pattern.size()); }
};

struct SurfaceMesh {
    std::shared_ptr<const SurfaceTopology> topology;
    std::vector<Vec3> positions;          ///< mm, per vertex; identical for sewn ones
    std::vector<Eigen::Vector3f> normals; ///< unit, per vertex, to the outside; smooth within a patch
    std::uint64_t revision = 0;           ///< increases with each published mesh

    Box3 boundingBox() const
    {
        Box3 box;
        for (const Vec3& p : positions)
            box.extend(p);
        return box;
    }
};

using SurfaceMeshPtr = std::shared_ptr<const SurfaceMesh>;

} // namespace bolster
