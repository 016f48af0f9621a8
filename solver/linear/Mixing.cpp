#include "Mixing.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

// Of the moves' square:
constexpr double mostGrowth = 9;
constexpr double mostLost = 100;
constexpr double better = 0.25;
constexpr int patience = 50; // iterations

constexpr double ridge = 1e-7; // of the normalised system: changes may be nearly the same

using Run = Eigen::Map<Eigen::ArrayXf>;

/// The numbers of columns, one after the other.
Run runOf(Eigen::Ref<Eigen::Matrix4Xf> columns, int begin, int end)
{
    return {columns.data() + 4 * std::ptrdiff_t(begin), 4 * (end - begin)};
}

} // namespace

void Mixing::forget()
{
    m_best = m_better = std::numeric_limits<double>::infinity();
    m_sinceBetter = 0;
    m_square = 0;
    beginAnew();
}

bool Mixing::lost() const
{
    return m_square > mostLost * m_best || m_sinceBetter > patience;
}

void Mixing::beginAnew()
{
    m_begun = false;
    m_known = 0;
    m_next = 0;
}

void Mixing::makeRoom(Eigen::Index count)
{
    if (m_before.cols() == count)
        return;
    for (Eigen::Matrix4Xf* columns : {&m_before, &m_step})
        columns->setZero(4, count);
    for (int k = 0; k < depth; ++k) {
        m_changes[k].setZero(4, count);
        m_ways[k].setZero(4, count);
    }
    m_sums.resize(WorkerPool::chunkCount(static_cast<int>(count)));
    forget();
}

void Mixing::mix(double share, WorkerPool& pool, Moves moves)
{
    makeRoom(moves.cols());
    const Products products = remember(static_cast<float>(share), pool, moves);
    m_square = products[2 * depth];
    if (m_begun) {
        const double change = products[m_next];
        m_gains[m_next] = change > 0 ? std::sqrt(m_stepSquare / change) : 0;
        for (int k = 0; k < depth; ++k) {
            m_gram(m_next, k) = m_gram(k, m_next) = products[k];
            m_right[k] = products[depth + k];
        }
        m_known = std::min(m_known + 1, depth);
        m_next = (m_next + 1) % depth;
    }
    if (!m_begun || m_square > mostGrowth * m_least) {
        beginAnew();
        m_least = m_square;
    }
    m_begun = true;
    m_least = std::min(m_least, m_square);
    m_best = std::min(m_best, m_square);
    ++m_sinceBetter;
    if (m_square < better * m_better) {
        m_better = m_square;
        m_sinceBetter = 0;
    }

    const Eigen::VectorXf back = shares();
    std::vector<double> squares(m_sums.size());
    pool.forChunks(static_cast<int>(moves.cols()), [&](int chunk, int begin, int end) {
        Run step = runOf(moves, begin, end);
        for (Eigen::Index k = 0; k < back.size(); ++k)
            step -= back[k] * runOf(m_ways[static_cast<std::size_t>(k)], begin, end);
        runOf(m_step, begin, end) = step;
        squares[static_cast<std::size_t>(chunk)] = static_cast<double>(step.square().sum());
    });
    m_stepSquare = 0;
    for (const double square : squares)
        m_stepSquare += square;
}

double Mixing::left() const
{
    if (m_known < depth)
        return std::numeric_limits<double>::infinity();
    if (m_square == 0)
        return 0;
    return *std::ranges::max_element(m_gains) * std::sqrt(m_square / m_stepSquare);
}

/// Takes the plain moves, of which only a share is made.
Mixing::Products Mixing::remember(float share, WorkerPool& pool, Moves moves)
{
    const auto next = static_cast<std::size_t>(m_next);
    pool.forChunks(static_cast<int>(moves.cols()), [&](int chunk, int begin, int end) {
        Products& sums = m_sums[static_cast<std::size_t>(chunk)];
        sums.setZero();
        Run now = runOf(moves, begin, end), before = runOf(m_before, begin, end);
        now *= share;
        sums[2 * depth] = static_cast<double>(now.square().sum());
        if (m_begun) {
            Run change = runOf(m_changes[next], begin, end);
            change = now - before;
            runOf(m_ways[next], begin, end) = runOf(m_step, begin, end) + change;
            for (int k = 0; k < depth; ++k) {
                const Run other = runOf(m_changes[static_cast<std::size_t>(k)], begin, end);
                sums[k] = static_cast<double>((change * other).sum());
                sums[depth + k] = static_cast<double>((now * other).sum());
            }
        }
        before = now;
    });
    Products total = Products::Zero();
    for (const Products& sums : m_sums)
        total += sums;
    return total;
}

/// Of the ways, those with which the moves would have been least.
Eigen::VectorXf Mixing::shares() const
{
    Eigen::MatrixXd gram = m_gram.topLeftCorner(m_known, m_known);
    const Eigen::VectorXd lengths = gram.diagonal().cwiseSqrt();
    if (m_known == 0 || !(lengths.minCoeff() > 0)) // moves that did not change at all
        return {};
    gram.array() /= (lengths * lengths.transpose()).array();
    gram.diagonal().array() += ridge;
    const Eigen::VectorXd right = m_right.head(m_known).array() / lengths.array();
    const Eigen::VectorXd found = gram.ldlt().solve(right).array() / lengths.array();
    return found.allFinite() ? Eigen::VectorXf(found.cast<float>()) : Eigen::VectorXf();
}

} // namespace bolster
