// Seams over which the sheet goes on: C1, G1, and those of a patch with itself (paper, section 3.4).
#pragma once

#include "SheetMoment.h"
#include "WorkerPool.h"

namespace bolster {

/// At an outline a frame is fitted to half a ring and smoothed towards one side only, which makes every plain seam
/// a free hinge. Between two patches that is wanted: a box has edges. Along a smooth seam the frames are fitted to
/// the rings of both sides instead, the other one's turned into the own pattern plane, and each as stiff as its
/// fabric (or the pulls on both rings would turn the sheet as a whole, without end where nothing resists):
/// - C1: so that the tangents of both stretches agree. The frames become equal, and the texture runs on.
/// - G1: so that the seam runs the same way in both frames. Only the normals become equal; the texture may turn.
/// - C0 of a patch with itself: like C1 unless the sides really meet at an angle. A tube that is cut from one piece
///   would become a drop otherwise (17 % off its radius, measured).
class SmoothSeams {
public:
    /// `rest` has the moments S_i = sum w e e^T of the rings.
    SmoothSeams(const SewnMesh& mesh, const std::vector<Eigen::Matrix2d>& rest);

    /// Replaces the right-hand sides A_i qhat_i of L2 (one column per vertex) at and beside these seams.
    /// `sheet` is the present one.
    void correct(const SheetMoment& sheet, WorkerPool& pool, Columns& right) const;

    /// The vertices whose right-hand sides it replaces.
    std::vector<int> vertices() const;

    /// Per vertex, what must be added to its diagonal in L2's matrix (not to its residual). The other side's frames
    /// are those of the iteration before, and the answer to them would overshoot from one to the next.
    std::vector<double> damping() const;

private:
    using Matrix32 = Eigen::Matrix<double, 3, 2>;
    enum class Kind { Self, C1, G1 };

    struct Side {
        Kind kind = Kind::Self;
        int partner = 0;
        double stiffness = 1; ///< of the partner's fabric, in terms of the vertex'
        Eigen::Matrix2d to;   ///< from the partner's pattern plane to the vertex'
        Quat turnBack;        ///< with which a partner's frame is one of the vertex' plane
        Eigen::Matrix2d rest; ///< S of the partner, in its own plane
        int before = 0;       ///< the vertex' neighbours along the seam
        int after = 0;
    };
    struct Joint {
        int vertex = 0;
        int part = 0;
        Eigen::Matrix2d rest;
        std::vector<Side> sides;
        std::vector<double> flux; ///< per ring edge: what smoothing loses at the border
    };
    /// A vertex beside the seam. Its ring is lopsided, so its fit belongs to a point a little off.
    struct Lopsided {
        int vertex = 0;
        std::vector<double> offset; ///< per ring edge: step back to the vertex along the frames' gradient
    };

    bool nearTip(int part, int v, int w) const;
    void join(const SurfaceTopology::Chain& seam, Continuity continuity, const std::vector<int>& partOf,
              const std::vector<Eigen::Matrix2d>& rest);
    void findLopsided(const std::vector<Eigen::Matrix2d>& rest);
    double widthOf(const Joint& joint) const;
    void boundFlux(Joint& joint) const;
    double dampingOf(const Joint& joint) const;
    Matrix32 covariance(const SheetMoment& sheet, int vertex) const;
    Eigen::Matrix2d mapNow(const Joint& joint, const Side& side, const SheetMoment& sheet, const Matrix32& own,
                           const Matrix32& other) const;
    Eigen::Vector4d turnToPartners(const Joint& joint, const Columns& frames) const;
    double fitBothSides(const Joint& joint, const SheetMoment& sheet, Columns& right) const;
    template <class Frame>
    Eigen::Vector4d ringSum(int vertex, const std::vector<double>& weights, const Frame& frame) const;

    const SewnMesh& m_mesh;
    std::vector<Joint> m_joints;
    std::vector<Lopsided> m_lopsided;
};

} // namespace bolster
