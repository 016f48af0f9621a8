#include "PackedFactor.h"

#include "LargePages.h"
#include "Multifrontal.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace bolster {

namespace {

constexpr std::size_t lineSize = 16;    // numbers in a cache line
constexpr std::size_t cached = 4 << 20; // bytes

std::size_t inChunks(int rows)
{
    return 4 * static_cast<std::size_t>((rows + 3) / 4);
}

std::size_t diagonalSize(int width)
{
    std::size_t size = 0;
    for (int row = 0; row < width; row += 4)
        size += 4 * static_cast<std::size_t>(std::min(width, row + 4));
    return size;
}

} // namespace

void PackedFactor::Free::operator()(float* memory) const
{
    std::free(memory);
}

PackedFactor::Memory PackedFactor::allocate(std::size_t count)
{
    const std::size_t lines = count / lineSize + 2; // with room behind the last
    const std::size_t page = lines * 64 < largePage ? 64 : largePage;
    const std::size_t bytes = (lines * 64 + page - 1) / page * page;
    auto* memory = static_cast<float*>(std::aligned_alloc(page, bytes));
    if (!memory)
        throw std::bad_alloc();
    wishLargePages(memory, bytes);
    std::fill_n(memory, lines * lineSize, 0.0F);
    return Memory(memory);
}

PackedFactor::PackedFactor(SymbolicFactor symbolic)
    : m_symbolic(std::move(symbolic))
{
    int longest = 0;
    for (const SupernodeShape& shape : m_symbolic.nodes) {
        PackedNode node;
        node.first = shape.first;
        node.width = shape.width;
        node.below = shape.below;
        node.diagonal = m_valueCount;
        node.panel = node.diagonal + diagonalSize(node.width);
        m_valueCount = node.panel + inChunks(node.below) * static_cast<std::size_t>(node.width);
        m_valueCount = (m_valueCount + lineSize - 1) / lineSize * lineSize;
        longest = std::max({longest, node.below, node.width});
        m_nodes.push_back(node);
    }
    m_values = allocate(m_valueCount);
    m_x = allocate(4 * static_cast<std::size_t>(m_symbolic.size() + 2 * (shared() + 1)));
    for (Memory& scratch : m_scratch)
        scratch = allocate(4 * static_cast<std::size_t>(longest) + lineSize);
    placeRows();
}

/// The columns that part the halves, as this half sees them.
float* PackedFactor::ownShared(int half) const
{
    return m_x.get() + 4 * static_cast<std::size_t>(m_symbolic.size() + half * (shared() + 1));
}

void PackedFactor::placeRows()
{
    const int outside = m_symbolic.outside();
    for (int p = 0; p < 3; ++p) {
        const auto own = static_cast<std::uint32_t>(ownShared(p == 1 ? 1 : 0) - m_x.get());
        const std::uint32_t zeros = own + 4 * static_cast<std::uint32_t>(shared());
        for (std::size_t n = m_symbolic.partStart[p]; n < m_symbolic.partStart[p + 1]; ++n) {
            const SupernodeShape& shape = m_symbolic.nodes[n];
            m_nodes[n].rows = m_rows.size();
            for (int k = 0; k < shape.below; ++k) {
                const int row = m_symbolic.rows[shape.rows + static_cast<std::size_t>(k)];
                m_rows.push_back(p < 2 && row >= outside ? own + 4 * static_cast<std::uint32_t>(row - outside)
                                                         : 4 * static_cast<std::uint32_t>(row));
            }
            m_rows.resize(m_nodes[n].rows + inChunks(shape.below), zeros);
        }
    }
}

bool PackedFactor::factor(const double* values, WorkerPool& pool, const std::stop_token& stop)
{
    return factorFronts(
        m_symbolic, values, pool,
        [this](int node, const Eigen::Ref<const Eigen::MatrixXd>& block) {
            pack(m_nodes[static_cast<std::size_t>(node)], block);
        },
        stop);
}

void PackedFactor::pack(const PackedNode& node, const Eigen::Ref<const Eigen::MatrixXd>& block)
{
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(node.width, node.width);
    block.topRows(node.width).triangularView<Eigen::Lower>().solveInPlace(inverse);
    float* to = m_values.get() + node.diagonal;
    for (int row = 0; row < node.width; row += 4)
        for (int k = 0; k < std::min(node.width, row + 4); ++k)
            for (int r = row; r < row + 4; ++r)
                *to++ = r < node.width && k <= r ? static_cast<float>(inverse(r, k)) : 0.0F;
    for (int row = 0; row < node.below; row += 4)
        for (int k = 0; k < node.width; ++k)
            for (int r = row; r < row + 4; ++r)
                *to++ = r < node.below ? static_cast<float>(block(node.width + r, k)) : 0.0F;
}

std::span<const PackedNode> PackedFactor::part(int part) const
{
    const auto& start = m_symbolic.partStart;
    return std::span(m_nodes).subspan(start[part], start[part + 1] - start[part]);
}

void PackedFactor::solve(WorkerPool& pool)
{
    const PackedSpans view{m_values.get(), m_rows.data(), bytes() > cached};
    float* const x = m_x.get();
    float* const above = x + 4 * static_cast<std::size_t>(m_symbolic.outside());
    const std::size_t count = 4 * static_cast<std::size_t>(shared());
    pool.forTasks(2, [&](int half) {
        std::fill_n(ownShared(half), count + 4, 0.0F);
        solveForward(view, part(half), x);
    });
    for (std::size_t i = 0; i < count; ++i)
        above[i] += ownShared(0)[i] + ownShared(1)[i];
    solveForward(view, part(2), x);
    solveBackward(view, part(2), x, m_scratch[0].get());
    pool.forTasks(2, [&](int half) {
        std::copy_n(above, count, ownShared(half));
        solveBackward(view, part(half), x, m_scratch[half].get());
    });
}

} // namespace bolster
