// The cover in the middle of an iteration.
#pragma once

#include "SewnMesh.h"
#include "SheetState.h"

namespace bolster {

struct SheetMoment {
    const SewnMesh& mesh;
    const Columns& positions;               ///< per unknown: x y z 0, mm
    const Columns& frames;                  ///< per vertex: w x y z
    const Eigen::Matrix4Xf* turn = nullptr; ///< what outside() adds to them, if anything

    Vec3 position(int vertex) const { return positions.col(mesh.topology->unknown[vertex]).head<3>(); }
    /// Unit normal of a vertex of `part`, to the outside.
    Vec3 outside(const SewnMesh::Part& part, int vertex) const
    {
        Eigen::Vector4d frame = frames.col(vertex);
        if (turn)
            frame += turn->col(vertex).cast<double>();
        return rotationOf(frame).col(2) * part.outward;
    }
};

} // namespace bolster
