// The matrices of the two systems of an iteration.
#pragma once

#include "SewnMesh.h"

#include <Eigen/SparseCore>

#include <vector>

namespace bolster {

/// lambda_num^2 of a part, mm^2: its fabric's bending length without what the mesh adds of its own.
double bendingSquared(const SewnMesh::Part& part);

/// L1, 2 L per free unknown, each patch's weights scaled by its stiffness, plus what is soft: a little proximity,
/// and `ghostWeights` (gamma / D^2 per part). The lower triangle.
Eigen::SparseMatrix<double> positionMatrix(const SewnMesh& mesh, const std::vector<double>& ghostWeights);
/// L2, diag(A) + 2 lambda_num^2 L per vertex. The lower triangle; its pattern does not depend on the fabrics.
Eigen::SparseMatrix<double> frameMatrix(const SewnMesh& mesh);

} // namespace bolster
