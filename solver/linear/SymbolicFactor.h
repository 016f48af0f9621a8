// Where the numbers of a Cholesky factor will stand, found from the pattern of the matrix alone.
#pragma once

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace bolster {

/// Columns of the factor with the same rows below them. Children (in the elimination tree of nodes) come before
/// their parents.
struct SupernodeShape {
    int first = 0;           ///< column
    int width = 0;           ///< columns
    int below = 0;           ///< rows under the diagonal block
    int parent = -1;         ///< node, -1: none
    std::size_t rows = 0;    ///< in SymbolicFactor::rows
    std::size_t entries = 0; ///< in SymbolicFactor::entries
    int entryCount = 0;

    int height() const { return width + below; }
};

/// The supernodes of the factor of a matrix whose unknowns are eliminated in a given order. Unknowns are renumbered
/// so that the tree falls into two halves, which do not touch each other, and what parts them.
class SymbolicFactor {
public:
    /// An entry of the matrix, and where it belongs in the node's front: height() rows, column after column.
    struct Entry {
        int source = 0; ///< index of its value
        int target = 0;
    };

    SymbolicFactor() = default;
    /// The lower triangle of the matrix is read. Every column has a diagonal entry.
    SymbolicFactor(const Eigen::SparseMatrix<double>& lower, std::vector<int> order);

    int size() const { return static_cast<int>(slots.size()); }
    int outside() const; ///< the first column of what parts the halves

    std::vector<SupernodeShape> nodes;
    std::array<std::size_t, 4> partStart{}; ///< in the nodes: first half, second half, what parts them, end
    std::vector<int> rows;                  ///< rising, in the order of elimination
    std::vector<Entry> entries;
    std::vector<int> slots; ///< where each unknown comes in the elimination
};

} // namespace bolster
