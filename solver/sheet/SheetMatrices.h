// The matrices of the two systems of an iteration.
#pragma once

#include "SewnMesh.h"

#include <Eigen/SparseCore>

#include <vector>

namespace bolster {

/// L1, 2 L per free unknown, each patch's weights scaled by its stiffness, plus what is soft: a little proximity,
/// and `ghostWeights` (gamma / D^2 per part). The lower triangle.
Eigen::SparseMatrix<double> positionMatrix(const SewnMesh& mesh, const std::vector<double>& ghostWeights);
/// L2, diag(A) + 2 lambda_num^2 L per vertex, plus `rows` (mm^2 per vertex) on the diagonal: those of smooth seams
/// and held normals. The lower triangle; its pattern does not depend on the fabrics.
Eigen::SparseMatrix<double> frameMatrix(const SewnMesh& mesh, const std::vector<double>& rows);

} // namespace bolster
