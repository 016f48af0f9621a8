#include "PackedFactor.h"

#include <cholmod.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <numeric>

namespace bolster {

namespace {

constexpr std::size_t lineSize = 16; // numbers in a cache line

/// CHOLMOD's arrays with their types.
struct Supernodes {
    explicit Supernodes(const cholmod_factor& factor)
        : count(static_cast<int>(factor.nsuper))
        , first(static_cast<const int*>(factor.super))
        , rowStart(static_cast<const int*>(factor.pi))
        , valueStart(static_cast<const int*>(factor.px))
        , rows(static_cast<const int*>(factor.s))
        , values(static_cast<const double*>(factor.x))
    {}

    int width(int node) const { return first[node + 1] - first[node]; }
    int height(int node) const { return rowStart[node + 1] - rowStart[node]; }

    int count;
    const int* first;
    const int* rowStart;
    const int* valueStart;
    const int* rows;
    const double* values;
};

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
    auto* memory = static_cast<float*>(std::aligned_alloc(64, lines * 64));
    if (!memory)
        throw std::bad_alloc();
    std::fill_n(memory, lines * lineSize, 0.0F);
    return Memory(memory);
}

PackedFactor::PackedFactor(const cholmod_factor_struct& factor)
{
    const Supernodes super(factor);
    std::vector<int> nodeOf(factor.n), parent(super.count, -1);
    std::vector<double> work(super.count);
    for (int s = 0; s < super.count; ++s) {
        std::fill(nodeOf.begin() + super.first[s], nodeOf.begin() + super.first[s + 1], s);
        work[s] = static_cast<double>(super.width(s)) * super.height(s);
    }
    for (int s = 0; s < super.count; ++s)
        if (super.height(s) > super.width(s))
            parent[s] = nodeOf[super.rows[super.rowStart[s] + super.width(s)]];
    std::vector<int> half(super.count);
    findHalves(parent, work, half);

    m_source.resize(super.count);
    std::iota(m_source.begin(), m_source.end(), 0);
    std::stable_sort(m_source.begin(), m_source.end(), [&](int a, int b) { return half[a] < half[b]; });
    std::vector<int> column(factor.n); // where CHOLMOD's columns come to lie
    int next = 0;
    for (const int s : m_source) {
        PackedNode node;
        node.first = next;
        node.width = super.width(s);
        node.below = super.height(s) - node.width;
        node.diagonal = m_valueCount;
        node.panel = node.diagonal + diagonalSize(node.width);
        node.rows = m_rows.size();
        m_rows.resize(m_rows.size() + static_cast<std::size_t>(node.below));
        m_valueCount = node.panel + inChunks(node.below) * static_cast<std::size_t>(node.width);
        m_valueCount = (m_valueCount + lineSize - 1) / lineSize * lineSize;
        m_longest = std::max({m_longest, node.below, node.width});
        std::iota(column.begin() + super.first[s], column.begin() + super.first[s + 1], next);
        next += node.width;
        m_nodes.push_back(node);
    }
    for (std::size_t n = 0; n < m_nodes.size(); ++n) {
        const int* rows = super.rows + super.rowStart[m_source[n]] + m_nodes[n].width;
        for (int r = 0; r < m_nodes[n].below; ++r)
            m_rows[m_nodes[n].rows + static_cast<std::size_t>(r)] = column[rows[r]];
    }
    for (int p = 0; p < 3; ++p)
        m_partStart[p] =
            static_cast<std::size_t>(std::ranges::count_if(half, [&](int inHalf) { return inHalf < p; }));
    m_partStart[3] = m_nodes.size();
    m_outside = m_partStart[2] < m_nodes.size() ? m_nodes[m_partStart[2]].first : next;

    const int* order = static_cast<const int*>(factor.Perm);
    m_slots.resize(factor.n);
    for (std::size_t k = 0; k < factor.n; ++k)
        m_slots[order[k]] = column[k];
    m_values = allocate(m_valueCount);
    m_x = allocate(4 * factor.n);
    for (int h = 0; h < 2; ++h) {
        m_spill[h] = allocate(4 * (factor.n - static_cast<std::size_t>(m_outside)));
        m_scratch[h] = allocate(4 * static_cast<std::size_t>(m_longest) + lineSize);
    }
    update(factor);
}

/// Divides the forest of nodes into two halves of like work (0, 1) and what lies above both (2): the heaviest
/// subtree is opened until the halves are even or its root is too small to matter.
void PackedFactor::findHalves(const std::vector<int>& parent, const std::vector<double>& work,
                              std::vector<int>& half) const
{
    constexpr double even = 0.05; // of all work
    constexpr int mostOpened = 64;
    const int count = static_cast<int>(parent.size());
    std::vector<double> below = work; // with all descendants
    std::vector<std::vector<int>> children(count);
    std::vector<int> roots;
    for (int s = 0; s < count; ++s) { // children come before their parents
        if (parent[s] < 0)
            roots.push_back(s);
        else {
            below[parent[s]] += below[s];
            children[parent[s]].push_back(s);
        }
    }
    const double all = std::accumulate(work.begin(), work.end(), 0.0);
    std::fill(half.begin(), half.end(), 0);
    std::vector<int> subtreeHalf;
    for (int opened = 0;; ++opened) {
        std::ranges::sort(roots, [&](int a, int b) { return std::pair(-below[a], a) < std::pair(-below[b], b); });
        double load[2] = {0, 0};
        subtreeHalf.clear();
        for (const int root : roots) {
            subtreeHalf.push_back(load[0] <= load[1] ? 0 : 1);
            load[subtreeHalf.back()] += below[root];
        }
        if (opened == mostOpened || std::abs(load[0] - load[1]) < even * all || children[roots.front()].empty())
            break;
        const int opening = roots.front();
        half[opening] = 2;
        roots.front() = children[opening].back();
        roots.insert(roots.end(), children[opening].begin(), children[opening].end() - 1);
    }
    for (std::size_t r = 0; r < roots.size(); ++r)
        half[roots[r]] = subtreeHalf[r];
    for (int s = count - 1; s >= 0; --s)
        if (parent[s] >= 0 && half[parent[s]] != 2)
            half[s] = half[parent[s]];
}

void PackedFactor::update(const cholmod_factor_struct& factor)
{
    const Supernodes super(factor);
    Eigen::MatrixXd inverse;
    for (std::size_t n = 0; n < m_nodes.size(); ++n) {
        const PackedNode& node = m_nodes[n];
        const int s = m_source[n];
        const Eigen::Map<const Eigen::MatrixXd> block(super.values + super.valueStart[s], super.height(s),
                                                      node.width);
        inverse.setIdentity(node.width, node.width);
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
}

std::span<const PackedNode> PackedFactor::part(int part) const
{
    return std::span(m_nodes).subspan(m_partStart[part], m_partStart[part + 1] - m_partStart[part]);
}

void PackedFactor::solve(Vectors& x, WorkerPool& pool)
{
    const PackedView view{m_values.get(), m_rows.data()};
    float* const work = m_x.get();
    const std::size_t spilled = 4 * (m_slots.size() - static_cast<std::size_t>(m_outside));
    std::copy_n(x.data(), x.size(), work);
    pool.forTasks(2, [&](int half) {
        std::fill_n(m_spill[half].get(), spilled, 0.0F);
        solveForward(view, part(half), work, m_outside, m_spill[half].get());
    });
    float* const above = work + 4 * static_cast<std::size_t>(m_outside);
    for (std::size_t i = 0; i < spilled; ++i)
        above[i] += m_spill[0][i] + m_spill[1][i];
    solveForward(view, part(2), work, 0, nullptr);
    solveBackward(view, part(2), work, m_scratch[0].get());
    pool.forTasks(2, [&](int half) { solveBackward(view, part(half), work, m_scratch[half].get()); });
    std::copy_n(work, x.size(), x.data());
}

} // namespace bolster
