// The inner loops of PackedFactor, compiled for several instruction sets and chosen at run time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace bolster {

/// Columns of the factor with the same rows below them (a supernode). The panel follows its diagonal block. Blocks
/// are stored in chunks of four rows, in each chunk column after column; rows that fill the last chunk up are 0.
struct PackedNode {
    int first = 0;            ///< column
    int width = 0;            ///< columns
    int below = 0;            ///< rows under the diagonal block
    std::size_t diagonal = 0; ///< in the values: the inverted diagonal block, chunk c up to column 4 c + 3
    std::size_t panel = 0;    ///< in the values: what lies under it
    std::size_t rows = 0;     ///< in the places of rows, which fill up the last chunk, too
};

/// Vectors hold four numbers per unknown and are aligned to 64 bytes, with 16 numbers of room behind the last.
struct PackedSpans {
    const float* values = nullptr;
    const std::uint32_t* rows = nullptr; ///< where the numbers of a row begin in x; any that are 0 fill up a chunk
    bool streamed = false;               ///< whether the values are too many for a cache
};

/// x := L^-1 x for these nodes, in this order.
void solveForward(const PackedSpans& factor, std::span<const PackedNode> nodes, float* x);
/// x := L^-T x for these nodes, last first. `scratch` has room for the longest list of rows and columns.
void solveBackward(const PackedSpans& factor, std::span<const PackedNode> nodes, float* x, float* scratch);

/// "AVX2" ...
const char* packedInstructions();

} // namespace bolster
