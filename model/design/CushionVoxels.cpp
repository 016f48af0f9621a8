#include "CushionVoxels.h"

#include <algorithm>

namespace bolster {

double voxelCount(const Box3& box, double edge, int margin)
{
    return box.isEmpty() ? 0 : ((box.sizes() / edge).array().ceil() + 1 + 2 * margin).prod();
}

double fittingVoxel(const Cushion& cushion, const Frame& frame, const TriangleMesh& mesh)
{
    Box3 box;
    for (const TriangleMesh::Part& part : mesh.parts)
        if (cushion.parts.empty() || std::ranges::find(cushion.parts, part.name) != cushion.parts.end())
            for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t)
                for (const std::uint32_t corner : mesh.triangles[t])
                    box.extend(frame.scale * mesh.points[corner]);
    double edge = Cushion().voxel;
    if (box.isEmpty())
        return edge;
    box = Box3(box.min().array() - cushion.dilation, box.max().array() + cushion.dilation);
    constexpr double step = 0.5, coarsest = 100; // mm
    while (edge < coarsest && voxelCount(box, edge, cushionMargin) > mostVoxels)
        edge += step;
    return edge;
}

} // namespace bolster
