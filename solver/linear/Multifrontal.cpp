#include "Multifrontal.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

using Block = Eigen::Map<Eigen::MatrixXd>;

constexpr int smallFront = 48;           // rows: below, plain loops beat Eigen's blocked ones
constexpr double worstCondition = 1e-15; // of the pivots

/// One part of the tree: what a thread works with. What a node leaves for its parent lies on a stack, because a
/// node's children are always the last that were finished in its part.
class Part {
public:
    /// `updates`: what each node of any part leaves, a matrix over its rows below.
    Part(const SymbolicFactor& symbolic, const double* values, std::vector<const double*>& updates)
        : m_symbolic(symbolic)
        , m_values(values)
        , m_updates(updates)
        , m_place(static_cast<std::size_t>(symbolic.size()))
    {}

    template <class Take>
    bool factor(std::size_t begin, std::size_t end, const std::vector<std::vector<int>>& children, const Take& take,
                const std::stop_token& stop)
    {
        reserve(begin, end, children);
        for (std::size_t s = begin; s < end; ++s) {
            if (stop.stop_requested())
                return false;
            const SupernodeShape& node = m_symbolic.nodes[s];
            Block front(m_front.data(), node.height(), node.height());
            assemble(s, children[s], front);
            if (!eliminate(front, node.width))
                return false;
            take(static_cast<int>(s), front.leftCols(node.width));
            push(s, begin, children[s], front);
        }
        return true;
    }

    double leastPivot = std::numeric_limits<double>::infinity();
    double largestPivot = 0;

private:
    static std::size_t updateSize(const SupernodeShape& node)
    {
        return static_cast<std::size_t>(node.below) * static_cast<std::size_t>(node.below);
    }

    /// Room for the largest front and the highest stack.
    void reserve(std::size_t begin, std::size_t end, const std::vector<std::vector<int>>& children)
    {
        std::size_t front = 0, stack = 0, highest = 0;
        for (std::size_t s = begin; s < end; ++s) {
            const SupernodeShape& node = m_symbolic.nodes[s];
            front =
                std::max(front, static_cast<std::size_t>(node.height()) * static_cast<std::size_t>(node.height()));
            for (const int child : children[s])
                if (static_cast<std::size_t>(child) >= begin)
                    stack -= updateSize(m_symbolic.nodes[child]);
            stack += updateSize(node);
            highest = std::max(highest, stack);
        }
        m_front.resize(front);
        m_stack.resize(highest);
    }

    /// The matrix' entries, and what the children leave.
    void assemble(std::size_t s, const std::vector<int>& children, Block& front)
    {
        const SupernodeShape& node = m_symbolic.nodes[s];
        const int height = node.height();
        for (int c = 0; c < height; ++c)
            std::fill_n(&front(c, c), height - c, 0.0);
        const SymbolicFactor::Entry* const entries = m_symbolic.entries.data() + node.entries;
        for (int k = 0; k < node.entryCount; ++k)
            front.data()[entries[k].target] += m_values[entries[k].source];
        const int* const rows = m_symbolic.rows.data() + node.rows;
        for (int c = 0; c < node.width; ++c)
            m_place[node.first + c] = c;
        for (int r = 0; r < node.below; ++r)
            m_place[rows[r]] = node.width + r;
        for (const int child : children)
            add(m_symbolic.nodes[child], m_updates[child], front);
    }

    void add(const SupernodeShape& child, const double* update, Block& front)
    {
        const int* const rows = m_symbolic.rows.data() + child.rows;
        m_local.resize(static_cast<std::size_t>(child.below));
        for (int r = 0; r < child.below; ++r)
            m_local[r] = m_place[rows[r]];
        for (int c = 0; c < child.below; ++c) {
            double* const to = front.data() + static_cast<std::ptrdiff_t>(m_local[c]) * front.rows();
            const double* const from = update + static_cast<std::ptrdiff_t>(c) * child.below;
            for (int r = c; r < child.below; ++r)
                to[m_local[r]] += from[r];
        }
    }

    /// The first `width` columns become those of L, what is right of them the update for the parent.
    bool eliminate(Block& front, int width)
    {
        const Eigen::Index below = front.rows() - width;
        if (front.rows() <= smallFront) {
            if (!eliminateSmall(front, width))
                return false;
        } else {
            auto diagonal = front.topLeftCorner(width, width);
            Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(diagonal);
            if (cholesky.info() != Eigen::Success)
                return false;
            auto panel = front.bottomLeftCorner(below, width);
            diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(panel);
            front.bottomRightCorner(below, below).selfadjointView<Eigen::Lower>().rankUpdate(panel, -1);
        }
        for (int k = 0; k < width; ++k) {
            const double pivot = front(k, k);
            if (!(pivot > 0) || !std::isfinite(pivot))
                return false;
            leastPivot = std::min(leastPivot, pivot);
            largestPivot = std::max(largestPivot, pivot);
        }
        return true;
    }

    static bool eliminateSmall(Block& front, int width)
    {
        const int height = static_cast<int>(front.rows());
        for (int k = 0; k < width; ++k) {
            double* const column = front.data() + static_cast<std::ptrdiff_t>(k) * height;
            if (!(column[k] > 0))
                return false;
            const double scale = 1 / std::sqrt(column[k]);
            for (int r = k; r < height; ++r)
                column[r] *= scale;
            for (int c = k + 1; c < height; ++c) {
                double* const to = front.data() + static_cast<std::ptrdiff_t>(c) * height;
                const double factor = column[c];
                for (int r = c; r < height; ++r)
                    to[r] -= factor * column[r];
            }
        }
        return true;
    }

    /// In the place of the children's updates, which are used up.
    void push(std::size_t s, std::size_t begin, const std::vector<int>& children, const Block& front)
    {
        const SupernodeShape& node = m_symbolic.nodes[s];
        for (const int child : children)
            if (static_cast<std::size_t>(child) >= begin)
                m_top -= updateSize(m_symbolic.nodes[child]);
        double* const to = m_stack.data() + m_top;
        m_updates[s] = to;
        for (int c = 0; c < node.below; ++c)
            std::copy_n(&front(node.width + c, node.width + c), node.below - c,
                        to + static_cast<std::ptrdiff_t>(c) * node.below + c);
        m_top += updateSize(node);
    }

    const SymbolicFactor& m_symbolic;
    const double* m_values;
    std::vector<const double*>& m_updates;
    std::vector<int> m_place; // of columns and rows in the present front
    std::vector<int> m_local;
    std::vector<double> m_front, m_stack;
    std::size_t m_top = 0;
};

} // namespace

bool factorFronts(const SymbolicFactor& symbolic, const double* values, WorkerPool& pool,
                  const std::function<void(int, const Eigen::Ref<const Eigen::MatrixXd>&)>& take,
                  const std::stop_token& stop)
{
    std::vector<std::vector<int>> children(symbolic.nodes.size());
    for (std::size_t s = 0; s < symbolic.nodes.size(); ++s)
        if (symbolic.nodes[s].parent >= 0)
            children[symbolic.nodes[s].parent].push_back(static_cast<int>(s));
    std::vector<const double*> updates(symbolic.nodes.size());
    std::vector<Part> parts(3, Part(symbolic, values, updates));
    bool sound[3] = {false, false, false};
    const auto run = [&](int part) {
        sound[part] =
            parts[part].factor(symbolic.partStart[part], symbolic.partStart[part + 1], children, take, stop);
    };
    pool.forTasks(2, run);
    if (!sound[0] || !sound[1])
        return false;
    run(2);
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    for (const Part& part : parts) {
        least = std::min(least, part.leastPivot);
        largest = std::max(largest, part.largestPivot);
    }
    return sound[2] && least * least > worstCondition * largest * largest;
}

} // namespace bolster
