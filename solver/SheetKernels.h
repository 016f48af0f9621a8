// The loops over all vertices of an iteration, compiled for several instruction sets and chosen at run time.
#pragma once

#include "SewnMesh.h"
#include "SheetState.h"

#include <vector>

namespace bolster {

/// What the loops need of the mesh, packed. Symbols are those of docs/solver.md.
struct SheetRings {
    explicit SheetRings(const SewnMesh& mesh);

    struct Edge {
        int vertex = 0;
        int unknown = 0;
        double weight = 0;       ///< w_ij
        double pull[2] = {0, 0}; ///< w_ij e_ij
    };
    struct Vertex {
        int unknown = 0;
        int firstEdge = 0;
        double area = 0;               ///< A_i
        double weight = 0;             ///< sum of w_ij
        double pull[2] = {0, 0};       ///< sum of w_ij e_ij
        double inverse[3] = {0, 0, 0}; ///< of the regularised S_i: xx, xy, yy
    };

    std::vector<Edge> edges;      ///< ring after ring
    std::vector<Vertex> vertices; ///< and one more, where the last ring ends
};

// All for the vertices begin .. end - 1 of one part, so that parts of a mesh can be given to threads.

/// The local step: A_i qhat_i and T_i (xx, xy, yy, unused). `poisson` is nu.
void fitFrames(const SheetRings& rings, const Columns& positions, const Columns& frames, double poisson, int begin,
               int end, Columns& right, Columns& stretch);

/// The residual of L2, right_i - A_i q_i + bending * sum w_ij (q_j - q_i), in the order of `slots`; `bending` is
/// 2 lambda^2. False when some neighbours' quaternions lie in opposite hemispheres.
bool frameResiduals(const SheetRings& rings, const Columns& frames, const Columns& right, double bending, int begin,
                    int end, const std::vector<int>& slots, Eigen::Matrix4Xf& residuals);

/// Frames after L2 has answered, normalised, and the two columns of every R(q_i) T_i.
void turnFrames(const Columns& frames, const Eigen::Matrix4Xf& turns, const std::vector<int>& slots,
                const Columns& stretch, int begin, int end, Columns& turned, Columns& maps);

/// The elastic force of every vertex' ring: stiffness * sum w_ij (2 (p_j - p_i) - (M_i + M_j) e_ij).
void ringForces(const SheetRings& rings, const Columns& positions, const Columns& maps, double stiffness, int begin,
                int end, Columns& forces);

} // namespace bolster
