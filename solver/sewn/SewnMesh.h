// All patches in one system: rest shapes, sewn vertices merged, fixed vertices eliminated.
#pragma once

#include "Design.h"
#include "OutlineSampling.h"
#include "PatchTriangulator.h"
#include "SurfaceMesh.h"
#include "WorkerPool.h"

#include <memory>

namespace bolster {

/// Vertices belong to one patch each; `unknown` says which of them share a position. Unknowns are numbered free
/// ones first, then those held by fixation curves and handles. Symbols are those of docs/solver.md.
struct SewnMesh {
    struct Material {
        double poisson = 0.3;     ///< nu
        double stiffness = 1;     ///< scales the weights of the patch in L1
        double bendingLength = 6; ///< lambda, mm
        double pressure = 0;      ///< P
    };
    struct Part {
        ElementId patch{};
        int firstVertex = 0;
        int vertexCount = 0;
        int boundaryCount = 0; ///< the first vertices lie on the outline
        int component = 0;     ///< sewn component
        double outward = 1;    ///< +1: +z of the pattern plane is outside, -1: -z
        double meanEdge = 0;   ///< h, mm
        double area = 0;       ///< mm^2
        Material material;

        /// lambda_num^2, mm^2: the bending that is left to do for L2, since the mesh adds some of its own.
        double bendingSquared() const;
    };
    /// There are six for each vertex: small ones.
    struct RingEdge {
        int vertex = 0;
        float weight = 0; ///< w_ij
    };

    /// A vertex whose normal is held.
    struct Oriented {
        int vertex = 0;
        int part = 0;
        Vec3 direction = Vec3::Zero(); ///< unit
        Orientation::Kind kind = Orientation::Kind::Normal;
        double weight = 1;
    };

    /// A fancy seam on the published surface: each of its vertices is moved by -depth * share * profile(across)
    /// along the outside normal.
    struct Relief {
        struct Point {
            int vertex = 0;
            double across = 0; ///< -1 to 1
            double share = 1;  ///< less than 1 where the seam fades out
        };
        ElementId seam{};
        double depth = 0; ///< mm
        Profile profile = Profile::Round;
        std::vector<Point> points;
    };

    std::shared_ptr<const SurfaceTopology> topology;
    std::vector<Part> parts;
    std::vector<double> area;           ///< A_i, mm^2
    std::vector<int> cornerStart;       ///< CSR over `corners`, one more than vertices
    std::vector<std::uint32_t> corners; ///< the triangles of each vertex, increasing
    std::vector<int> ringStart;         ///< CSR over `ring`, one more than vertices
    std::vector<RingEdge> ring;
    std::vector<Continuity> continuity; ///< of the topology's seams
    int freeCount = 0;
    std::vector<Vec3> targets; ///< of the fixed unknowns freeCount, freeCount + 1 ...
    std::vector<Oriented> oriented;
    std::vector<double> diameter; ///< D per sewn component, mm
    std::vector<char> anchored;   ///< per component: some vertex is fixed
    std::vector<int> firstLine;   ///< per part: of the topology's lines
    std::vector<Relief> reliefs;  ///< by fancy seam

    int vertexCount() const { return static_cast<int>(area.size()); }
    int unknownCount() const { return static_cast<int>(topology->unknownCount); }
    const std::vector<Vec2>& rest() const { return topology->pattern; }
    /// e_ij of an edge of the vertex's ring, mm.
    Vec2 along(int vertex, const RingEdge& edge) const { return rest()[edge.vertex] - rest()[vertex]; }
    double largestDiameter() const;
};

/// One mesh per outline of the sampling.
SewnMesh buildSewnMesh(const Design& design, const OutlineSampling& sampling, const std::vector<PatchMesh>& meshes,
                       WorkerPool& pool);

/// The same triangles with another rest shape.
void reshape(SewnMesh& mesh, std::vector<Vec2> pattern, WorkerPool& pool);

/// Direction in which a chain of vertices runs at its k-th one, in the pattern plane.
Vec2 chainTangent(const std::vector<Vec2>& rest, const std::vector<std::uint32_t>& chain, std::size_t k);

/// Which seams and lines the topology calls creases. It becomes another one only where something has changed: views
/// keep what they have made of it.
void updateCreases(SewnMesh& mesh, const Design& design);
/// Fabric, pressure and continuity values again, when only these have changed.
void updateMaterials(SewnMesh& mesh, const Design& design);
/// Fixation targets and held normals again, when only these have changed.
void updateTargets(SewnMesh& mesh, const OutlineSampling& sampling);

} // namespace bolster
