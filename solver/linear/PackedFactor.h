// A Cholesky factor laid out for being solved with, often and fast.
#pragma once

#include "PackedKernels.h"
#include "SymbolicFactor.h"
#include "WorkerPool.h"

#include <Eigen/Core>

#include <memory>
#include <stop_token>
#include <vector>

namespace bolster {

/// Supernodes in single precision with inverted diagonal blocks, for four right-hand sides at once. Unknowns are
/// numbered in the order of their elimination: `slots()` says where each lies in x().
class PackedFactor {
public:
    using Workspace = Eigen::Map<Eigen::Matrix4Xf, Eigen::Aligned64>;

    PackedFactor() = default;
    explicit PackedFactor(SymbolicFactor symbolic);

    /// Computes the numbers, in double precision. `values` are those of the matrix that `symbolic` was made of.
    /// False when it is not positive definite or not finite, or when stopped.
    bool factor(const double* values, WorkerPool& pool, const std::stop_token& stop = {});

    const std::vector<int>& slots() const { return m_symbolic.slots; }
    /// What solve() works on, one column per unknown.
    Workspace x() { return {m_x.get(), 4, m_symbolic.size()}; }
    /// x := A^-1 x. The same bits on any number of threads: the work is always split at the same place.
    void solve(WorkerPool& pool);
    /// Memory that a solve reads twice.
    std::size_t bytes() const { return m_valueCount * sizeof(float); }

private:
    struct Free {
        void operator()(float* memory) const;
    };
    using Memory = std::unique_ptr<float[], Free>;
    static Memory allocate(std::size_t count);

    void placeRows();
    void pack(const PackedNode& node, const Eigen::Ref<const Eigen::MatrixXd>& block);
    std::span<const PackedNode> part(int part) const;
    int shared() const { return m_symbolic.size() - m_symbolic.outside(); }
    float* ownShared(int half) const;

    SymbolicFactor m_symbolic;
    std::vector<PackedNode> m_nodes;   // as in m_symbolic
    std::vector<std::uint32_t> m_rows; // where they lie in m_x
    Memory m_values;
    std::size_t m_valueCount = 0;
    /// One column per unknown, and for each half those that part them once more, then one of zeros: halves do not
    /// write to the same place, and rows that fill up a chunk have one.
    Memory m_x;
    Memory m_scratch[2];
};

} // namespace bolster
