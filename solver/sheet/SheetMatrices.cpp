#include "SheetMatrices.h"

namespace bolster {

namespace {

// Keeps a cover without fixations solvable. It is in the matrix only, so the fixed point does not feel it.
constexpr double proximity = 1e-2;

} // namespace

Eigen::SparseMatrix<double> positionMatrix(const SewnMesh& mesh, const std::vector<double>& ghostWeights)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(mesh.ring.size() + mesh.area.size());
    const auto& unknown = mesh.topology->unknown;
    for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
        const SewnMesh::Part& part = mesh.parts[p];
        const double d = mesh.diameter[part.component];
        const double soft = proximity / (d * d) + ghostWeights[p];
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const int row = static_cast<int>(unknown[v]);
            if (row >= mesh.freeCount)
                continue;
            double diagonal = soft * mesh.area[v];
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
                const int column = static_cast<int>(unknown[mesh.ring[k].vertex]);
                const double weight = 2 * part.material.stiffness * mesh.ring[k].weight;
                if (column == row)
                    continue;
                diagonal += weight;
                if (column < row)
                    entries.emplace_back(row, column, -weight);
            }
            entries.emplace_back(row, row, diagonal);
        }
    }
    Eigen::SparseMatrix<double> matrix(mesh.freeCount, mesh.freeCount);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::SparseMatrix<double> frameMatrix(const SewnMesh& mesh, const std::vector<double>& rows)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(mesh.ring.size() + mesh.area.size());
    for (const SewnMesh::Part& part : mesh.parts) {
        const double bending = 2 * part.bendingSquared();
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            double diagonal = mesh.area[v] + rows[v];
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
                diagonal += bending * mesh.ring[k].weight;
                if (mesh.ring[k].vertex < v) // kept even where it is 0, so that the pattern stays
                    entries.emplace_back(v, mesh.ring[k].vertex, -bending * mesh.ring[k].weight);
            }
            entries.emplace_back(v, v, diagonal);
        }
    }
    Eigen::SparseMatrix<double> matrix(mesh.vertexCount(), mesh.vertexCount());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace bolster
