// The per-vertex part of an iteration: frame and target stretch from the ring (paper, section 3.2; docs/solver.md).
#pragma once

#include "SheetState.h"

namespace bolster {

/// Pulls a collapsed ring back to its previous frame, times the vertex area; an absolute size, or it would stay
/// collapsed for ever.
inline constexpr double ringRegularisation = 4e-4;
/// Strain beyond which the preferred stretch answers no more.
inline constexpr double largestAnsweredStrain = 0.5;

/// What a vertex wants: its best-fitting frame, and the in-plane stretch that its material prefers there.
struct LocalFit {
    Eigen::Vector4d frame;
    Eigen::Matrix2d stretch;
};

/// `covariance` C_i = sum w (p_j - p_i) e^T (mm^2) and `rest` S_i = sum w e e^T of a ring with vertex area A_i
/// (mm^2), the previous frame, and the Poisson parameter nu. The frame has the sign of the previous one.
LocalFit fitVertex(const Eigen::Matrix<double, 3, 2>& covariance, const Eigen::Matrix2d& rest, double area,
                   const Eigen::Vector4d& previousFrame, double poisson);

} // namespace bolster
