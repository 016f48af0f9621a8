// The loops over all vertices of an iteration, compiled for several instruction sets and chosen at run time.
#pragma once

#include "SewnMesh.h"
#include "SheetState.h"
#include "WorkerPool.h"

#include <array>
#include <vector>

namespace bolster {

// What belongs to the mesh, what is corrected once more in the next iteration, and the columns of R(q_i) T_i are
// kept in single precision, since iterations wait for memory. Places and frames are in double precision. The
// rounded columns shake the cover by some 1e-8 of its size.

/// What the loops need of the mesh, packed. Symbols are those of docs/solver.md.
struct SheetRings {
    /// Measures the rings of a mesh; room is made only for one of another size.
    void measure(const SewnMesh& mesh, WorkerPool& pool);

    struct Edge {
        int vertex = 0;
        int unknown = 0;
        float weight = 0;       ///< w_ij
        float pull[2] = {0, 0}; ///< w_ij e_ij
    };
    struct Vertex {
        int unknown = 0;
        int firstEdge = 0;
    };

    std::vector<Edge> edges;      ///< ring after ring
    std::vector<Vertex> vertices; ///< and one more, where the last ring ends
    // Per vertex, and some more, since whole registers are read.
    std::vector<float> area;                   ///< A_i
    std::array<std::vector<float>, 3> inverse; ///< of the regularised S_i: xx, xy, yy
    std::vector<double> weight;                ///< sum of the ring's
    // Per vertex.
    std::vector<Vec2> pull; ///< sum of the ring's
};

/// Where the loops put what they find: four numbers for each vertex or unknown.
struct SheetResults {
    const int* turnSlots = nullptr; ///< where each vertex lies in `turns`
    float* turns = nullptr;         ///< L2's residuals, then its corrections
    float* stretch = nullptr;       ///< T_i - I: xx, xy, yy, 0
    double* fitted = nullptr;       ///< A_i qhat_i, if wanted

    const double* outer = nullptr; ///< forces that are not the ring's, if there are any
    /// Where each vertex' unknown lies in `moves` if the vertex alone has it and it is free, else -1.
    const int* moveSlots = nullptr;
    float* moves = nullptr;  ///< L1's residuals
    float* forces = nullptr; ///< of the other vertices
};

// All for the vertices begin .. end - 1 of one part, so that parts of a mesh can be given to threads.

/// The local step and the residual of L2, A_i (qhat_i - q_i) + bending * sum w_ij (q_j - q_i). `poisson` is nu,
/// `bending` is 2 lambda^2. False when quaternions of neighbours lie in opposite hemispheres.
bool fitFrames(const SheetRings& rings, const Columns& positions, const Columns& frames, double poisson,
               double bending, int begin, int end, const SheetResults& to);

/// Frames after L2 has answered, normalised, and the two columns of every R(q_i) T_i. `ahead` are the frames that
/// it was asked at; they become those for the next time, `beta` of the step further on. `back` leads from them to
/// the frames before the step, and then to those after it.
void turnFrames(double beta, int begin, int end, const SheetResults& results, Columns& ahead,
                Eigen::Matrix4Xf& back, Eigen::Matrix4Xf& maps);

/// The force on every vertex: stiffness * sum w_ij (2 (p_j - p_i) - (M_i + M_j) e_ij), and the outer one.
void ringForces(const SheetRings& rings, const Columns& positions, const Eigen::Matrix4Xf& maps, double stiffness,
                int begin, int end, const SheetResults& to);

/// Of the free unknowns.
struct PositionSlots {
    const int* slots = nullptr;    ///< where each lies in L1's solution
    const double* scale = nullptr; ///< 1 / D^2
};

struct Moved {
    double overshoot = 0; ///< above 0: against the acceleration
    double farthest = 0;  ///< move, squared, relative to D
    bool bounded = true;  ///< false when a move is not finite or longer than `mostMove`: there nothing has moved
};
/// Relative to D: what goes further has been thrown away by an instability.
inline constexpr double mostMove = 1e4;

/// `step` times the moves that L1 asks for, from where the unknowns were `ahead`; what `ahead` and `back` become is
/// told at turnFrames().
Moved movePositions(const PositionSlots& unknowns, const float* moves, double step, double beta, int begin, int end,
                    Columns& ahead, Eigen::Matrix4Xf& back);

} // namespace bolster
