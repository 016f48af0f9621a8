// Seams of a patch with itself: tubes and darts, where the sheet goes on across the seam.
#pragma once

#include "SewnMesh.h"

#include <Eigen/Core>

#include <functional>

namespace bolster {

/// At an outline a frame is fitted to half a ring and smoothed towards one side only, which makes every plain seam
/// a free hinge. Between two patches that is wanted: a box has edges. But a tube that is cut from one piece would
/// become a drop (17 % off its radius, measured). So along a seam of a patch with itself the frames are fitted to
/// both sides, unless the sides really meet at an angle.
class SelfSeams {
public:
    using Matrix32 = Eigen::Matrix<double, 3, 2>;

    /// `rest` has the moments S_i = sum w e e^T of the rings.
    SelfSeams(const SewnMesh& mesh, const std::vector<Eigen::Matrix2d>& rest);

    /// Replaces the right-hand sides A_i qhat_i of L2 (one column per vertex) at and beside these seams.
    /// `covariance(v)` is C_v at the present positions, `frames` are the present ones, `bendingSquared` is
    /// lambda_num^2 of the part.
    void correct(const Eigen::Matrix4Xd& frames, const std::function<Matrix32(int)>& covariance,
                 const std::function<double(int)>& bendingSquared, Eigen::Matrix4Xd& right) const;

private:
    struct Joint {
        int vertex = 0;
        int partner = 0;
        int part = 0;
        Eigen::Matrix2d turn;        // from the partner's side to the vertex's
        Eigen::Matrix2d rest;        // S of the vertex
        Eigen::Matrix2d partnerRest; // S of the partner, turned
        std::vector<double> flux;    // per ring edge: what smoothing loses at the border
    };
    /// A vertex beside the seam. Its ring is lopsided, so its fit belongs to a point a little off.
    struct Lopsided {
        int vertex = 0;
        std::vector<double> offset; // per ring edge: step back to the vertex along the frames' gradient
    };

    bool nearTip(int part, int v, int w) const;
    void join(const SurfaceTopology::Chain& seam, const std::vector<int>& partOf,
              const std::vector<Eigen::Matrix2d>& rest);
    void findLopsided(const std::vector<Eigen::Matrix2d>& rest);
    Eigen::Vector4d ringSum(int vertex, const std::vector<double>& weights,
                            const std::function<Eigen::Vector4d(int)>& frame) const;

    const SewnMesh& m_mesh;
    std::vector<Joint> m_joints;
    std::vector<Lopsided> m_lopsided;
};

} // namespace bolster
