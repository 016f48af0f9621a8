// The mesh optimisation itself: frames, then positions, by two prefactored systems (paper, section 3.2).
#pragma once

#include "FactoredSystem.h"
#include "FreeBody.h"
#include "Ghosts.h"
#include "Mixing.h"
#include "SewnMesh.h"
#include "SheetKernels.h"
#include "SheetState.h"
#include "SmoothSeams.h"
#include "WorkerPool.h"

#include <optional>
#include <stop_token>

namespace bolster {

/// Minimises the sheet's energy from a given state. docs/solver.md has the formulas; the names there are those in
/// the comments here. The mesh must outlive the optimizer.
class SheetOptimizer {
public:
    /// A stopped one is not ok().
    SheetOptimizer(const SewnMesh& mesh, WorkerPool& pool, Ghosts ghosts = {}, const std::stop_token& stop = {});

    /// False when a system could not be factored: nothing else may be called then.
    bool ok() const { return m_positions && m_positions->ok() && m_frames && m_frames->ok(); }
    /// Takes changed materials (stiffness, bending length) and continuities of seams into the matrices. Returns
    /// ok().
    bool refactor();
    /// Takes a changed rest shape into the forces, and into the matrices when it has become too different from
    /// theirs: up to then their solutions are good steps. Returns ok().
    bool reshape();
    /// How often the matrices have been factored: when that has not changed, they are the same.
    int factorings() const { return m_factorings; }

    /// Takes other soft targets. False when their weights differ from those in the matrix: refactor() must follow.
    bool replaceGhosts(Ghosts ghosts);
    const Ghosts& ghosts() const { return m_ghosts; }
    /// Whether the ghosts that are fits act. False when refactor() must follow.
    bool setFitting(bool on);
    /// What the ghosts do to the cover.
    void report(SolveReport& report) const;

    /// Positions of fixed unknowns are taken from the mesh's targets.
    void restart(SheetState state);
    /// Moves positions to where the present frames want them, without fitting frames first: a start whose rings are
    /// torn by sewing and fixing says nothing about frames yet.
    void relaxPositions();
    /// Makes the present positions those at rest, until the next restart: from now on each step goes without what
    /// L1 would move them by now, which is a load that stays.
    void standStill();
    /// Of what only iterations need; there can be none any more.
    void release();
    /// Accepts moved targets and changed pressure or Poisson parameters; positions go on from where they are.
    void retarget();

    enum class Acceleration {
        None,     ///< plain iterations of half a step, slower but never circling
        Momentum, ///< Nesterov's
        Mixing,   ///< Anderson's: near to rest it needs fewer iterations than momentum does
    };
    /// Whether it is another one than before.
    bool setAcceleration(Acceleration acceleration);
    /// See Mixing; of other accelerations nothing is known.
    bool lost() const { return m_mixing.lost(); }
    double left() const { return m_mixing.left(); }

    /// One iteration. Returns the largest move of a vertex relative to D, or nothing when a move is not finite or
    /// leaves every bound; vertices that would make one stay where they are.
    std::optional<double> iterate();

    SheetState state() const;
    /// How far the vertex that went farthest is from where it was when this was asked last, relative to D; 0 at
    /// first.
    double wayFromMark();
    const SewnMesh& mesh() const { return m_mesh; }

private:
    std::vector<double> frameRows() const;
    void precomputeRings();
    void numberSlots();
    bool factor();
    void findCorrectable();
    void measureRings();
    template <class Body>
    void forParts(const Body& body);
    void startHere();
    double nextMomentum() const;
    double beta() const;
    void alignFrames();
    void fit();
    void correctFits();
    void solveFrames();
    void solvePositions();
    std::optional<double> movePositions(double step);
    void addOuterForces();
    bool acts(const GhostSource& source) const { return m_fitting || !source.misfit(); }
    bool updateGhostWeights();
    std::vector<double> ghostWeights() const;
    double stableStep() const;

    const SewnMesh& m_mesh;
    WorkerPool& m_pool;
    std::optional<FactoredSystem> m_positions; // L1
    std::optional<FactoredSystem> m_frames;    // L2

    Ghosts m_ghosts;
    bool m_fitting = false;
    std::vector<double> m_gammas; // of all sources, per part

    SheetRings m_rings;
    SheetResults m_results;
    std::vector<Vec2> m_factored; // the rest shape that is in the matrices
    Columns m_mark;               // positions, see wayFromMark()
    double m_distortion = 1;      // of the present one against it
    int m_factorings = 0;
    std::vector<int> m_partOf;           // per vertex
    std::vector<Eigen::Matrix2d> m_rest; // S_i
    std::vector<int> m_moveSlots;        // as in SheetResults
    struct Merged {
        int slot = 0;           ///< of a free unknown
        int begin = 0, end = 0; ///< of its vertices in m_corners
    };
    std::vector<Merged> m_merged; // free unknowns with several vertices
    std::vector<int> m_corners;
    std::vector<double> m_scale; // per free unknown: 1 / D^2

    std::optional<SmoothSeams> m_smoothSeams;
    std::vector<FreeBody> m_freeBodies; // components that nothing holds

    // Of positions (x y z 0) and frames (w x y z). The present state is their sum. Steps vanish as the cover comes
    // to rest, so single precision does for them.
    struct Ahead {
        Columns positions, frames;
    };
    struct Back {
        Eigen::Matrix4Xf positions, frames;
    };
    Ahead m_ahead; // y: the extrapolated state from which an iteration starts
    Back m_back;   // from there to the present state
    Acceleration m_acceleration = Acceleration::Momentum;
    Mixing m_mixing;
    bool m_signsAgree = false;
    double m_momentum = 1;          // t_k of Nesterov's scheme
    bool m_overshot = false;        // the next iteration starts from the present state
    Eigen::Matrix4Xf m_drift;       // of standStill(), in the order of the factor; else empty
    std::vector<Moved> m_moved;     // per chunk of free unknowns
    Eigen::Matrix4Xf m_map;         // the two columns of R(q_i) T_i, per vertex
    Eigen::Matrix4Xf m_forces;      // per vertex, where several have one unknown
    Columns m_outer;                // per vertex: ghosts and pressure
    Columns m_displacements;        // per vertex: where a ghost source wants it, from where it is
    Columns m_fitted;               // A_i qhat_i, where frames are corrected afterwards
    Eigen::Matrix4Xf m_stretch;     // T_i - I
    std::vector<int> m_correctable; // vertices whose fits are
};

} // namespace bolster
