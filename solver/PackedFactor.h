// A Cholesky factor laid out for being solved with, often and fast.
#pragma once

#include "PackedKernels.h"
#include "WorkerPool.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

struct cholmod_factor_struct;

namespace bolster {

/// Supernodes in single precision with inverted diagonal blocks, for four right-hand sides at once. Unknowns are
/// numbered in the order of their elimination: `slots()` says where each lies in the vectors of solve().
class PackedFactor {
public:
    using Vectors = Eigen::Matrix<float, 4, Eigen::Dynamic>;

    PackedFactor() = default;
    /// From CHOLMOD's supernodal factor L L^T.
    explicit PackedFactor(const cholmod_factor_struct& factor);

    /// Other numbers in a factor of the same structure.
    void update(const cholmod_factor_struct& factor);

    const std::vector<int>& slots() const { return m_slots; }
    /// x := A^-1 x, one column per unknown. The same bits on any number of threads: the work is always split at the
    /// same place.
    void solve(Vectors& x, WorkerPool& pool);
    /// Memory that a solve reads twice.
    std::size_t bytes() const { return m_valueCount * sizeof(float); }

private:
    struct Free {
        void operator()(float* memory) const;
    };
    using Memory = std::unique_ptr<float[], Free>;
    static Memory allocate(std::size_t count);

    void findHalves(const std::vector<int>& parent, const std::vector<double>& work, std::vector<int>& half) const;
    std::span<const PackedNode> part(int part) const;

    std::vector<int> m_slots;
    std::vector<PackedNode> m_nodes;          // first half, second half, what parts them
    std::vector<int> m_source;                // CHOLMOD's number of each node
    std::array<std::size_t, 4> m_partStart{}; // in the nodes
    int m_outside = 0;                        // the first column of the third part
    int m_longest = 0;                        // rows or columns of a node
    std::vector<int> m_rows;
    Memory m_values;
    std::size_t m_valueCount = 0;
    Memory m_x, m_spill[2], m_scratch[2];
};

} // namespace bolster
