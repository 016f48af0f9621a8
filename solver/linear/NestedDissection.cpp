#include "NestedDissection.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace bolster {

namespace {

constexpr int leaf = 8;            // fewer unknowns stay as they are
constexpr int levelsWorthIt = 100; // from so many unknowns more than one way to cut is tried
constexpr int mostBins = 512;
constexpr double leastShare = 0.2; // of the smaller half

/// Both triangles without the diagonal, CSR.
struct Adjacency {
    std::vector<int> start;
    std::vector<int> neighbour;

    explicit Adjacency(const Eigen::SparseMatrix<double>& lower)
        : start(static_cast<std::size_t>(lower.cols()) + 1, 0)
    {
        eachEdge(lower, [&](int a, int b) {
            ++start[a + 1];
            ++start[b + 1];
        });
        std::partial_sum(start.begin(), start.end(), start.begin());
        neighbour.resize(static_cast<std::size_t>(start.back()));
        std::vector<int> next(start.begin(), start.end() - 1);
        eachEdge(lower, [&](int a, int b) {
            neighbour[next[a]++] = b;
            neighbour[next[b]++] = a;
        });
    }

    template <class Visit>
    static void eachEdge(const Eigen::SparseMatrix<double>& lower, Visit visit)
    {
        for (int column = 0; column < lower.outerSize(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry)
                if (entry.row() != column)
                    visit(static_cast<int>(entry.row()), column);
    }
};

class Dissection {
public:
    Dissection(const Adjacency& graph, const Eigen::Matrix3Xd& places, const std::stop_token& stop)
        : m_graph(graph)
        , m_places(places)
        , m_stop(stop)
        , m_order(static_cast<std::size_t>(places.cols()))
        , m_part(m_order.size(), 0)
        , m_bin(m_order.size(), 0)
        , m_bestBin(m_order.size(), 0)
        , m_parting(m_order.size(), 0)
    {
        std::iota(m_order.begin(), m_order.end(), 0);
    }

    std::vector<int> run()
    {
        divide(0, static_cast<int>(m_order.size()));
        return std::move(m_order);
    }

private:
    /// After bin `bin`; the unknowns that part the halves come from the lower or the upper side of it.
    struct Cut {
        double cost = std::numeric_limits<double>::infinity();
        int bin = -1;
        bool fromLower = false;
    };

    void divide(int begin, int end)
    {
        if (end - begin <= leaf || m_stop.stop_requested())
            return;
        const int part = ++m_parts;
        for (int i = begin; i < end; ++i)
            m_part[m_order[i]] = part;
        const Eigen::Matrix3d axes = principalAxes(begin, end);
        const Cut cut = bestCut(begin, end, part, axes);
        if (cut.bin < 0)
            return; // a clump in which everything touches everything
        const auto [middle, parting] = split(begin, end, cut);
        divide(begin, middle);
        divide(middle, parting);
        const Vec along = axes.col(1);
        std::sort(m_order.begin() + parting, m_order.begin() + end, [&](int a, int b) {
            return std::pair(m_places.col(a).dot(along), a) < std::pair(m_places.col(b).dot(along), b);
        });
    }

    /// Columns by rising extent.
    Eigen::Matrix3d principalAxes(int begin, int end) const
    {
        Vec centre = Vec::Zero();
        for (int i = begin; i < end; ++i)
            centre += m_places.col(m_order[i]);
        centre /= end - begin;
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for (int i = begin; i < end; ++i) {
            const Vec arm = m_places.col(m_order[i]) - centre;
            covariance += arm * arm.transpose();
        }
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        return solver.computeDirect(covariance).eigenvectors();
    }

    /// Planes across the two longest axes, and levels of distance along edges, which follow seams round corners.
    Cut bestCut(int begin, int end, int part, const Eigen::Matrix3d& axes)
    {
        Cut best;
        const auto consider = [&](int bins) {
            const Cut cut = sweep(begin, end, part, bins);
            if (!(cut.cost < best.cost))
                return;
            best = cut;
            for (int i = begin; i < end; ++i)
                m_bestBin[m_order[i]] = m_bin[m_order[i]];
        };
        const int count = end - begin;
        const int bins = std::clamp(static_cast<int>(3 * std::sqrt(count)), leaf, mostBins);
        binAlong(begin, end, axes.col(2), bins);
        consider(bins);
        if (count > levelsWorthIt) {
            binAlong(begin, end, axes.col(1), bins);
            consider(bins);
            int farEnd = m_order[begin];
            for (int round = 0; round < 3; ++round)
                farEnd = levelsFrom(farEnd, begin, end, part);
            consider(m_bin[farEnd] + 1);
        }
        return best;
    }

    void binAlong(int begin, int end, const Eigen::Vector3d& axis, int bins)
    {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int i = begin; i < end; ++i) {
            const double at = axis.dot(m_places.col(m_order[i]));
            low = std::min(low, at);
            high = std::max(high, at);
        }
        const double scale = high > low ? bins / (high - low) : 0;
        for (int i = begin; i < end; ++i) {
            const double at = (axis.dot(m_places.col(m_order[i])) - low) * scale;
            m_bin[m_order[i]] = at > 0 ? static_cast<int>(std::min(at, bins - 1.0)) : 0; // 0 for NaN, too
        }
    }

    /// Bins by the number of edges from `root`. Returns one of the farthest unknowns.
    int levelsFrom(int root, int begin, int end, int part)
    {
        for (int i = begin; i < end; ++i)
            m_bin[m_order[i]] = -1;
        m_queue.assign(1, root);
        m_bin[root] = 0;
        int unvisited = begin; // for parts that do not hang together
        for (std::size_t next = 0; std::ssize(m_queue) < end - begin || next < m_queue.size(); ++next) {
            if (next == m_queue.size()) {
                while (m_bin[m_order[unvisited]] >= 0)
                    ++unvisited;
                m_bin[m_order[unvisited]] = m_bin[m_queue.back()];
                m_queue.push_back(m_order[unvisited]);
            }
            const int here = m_queue[next];
            eachNeighbour(here, [&](int other) {
                if (m_part[other] != part || m_bin[other] >= 0)
                    return;
                m_bin[other] = std::min(m_bin[here] + 1, mostBins - 1);
                m_queue.push_back(other);
            });
        }
        return m_queue.back();
    }

    /// Counts for every cut between two bins how many unknowns would have to part the halves.
    Cut sweep(int begin, int end, int part, int bins) const
    {
        std::array<int, mostBins + 1> inBin, lowerChange, upperChange;
        for (auto* counts : {&inBin, &lowerChange, &upperChange})
            std::fill_n(counts->begin(), bins + 1, 0);
        for (int i = begin; i < end; ++i) {
            const int own = m_bin[m_order[i]];
            int least = own, most = own;
            eachNeighbour(m_order[i], [&](int other) {
                if (m_part[other] != part)
                    return;
                least = std::min(least, m_bin[other]);
                most = std::max(most, m_bin[other]);
            });
            ++inBin[own];
            ++lowerChange[own], --lowerChange[most]; // touches the upper half for cuts after own ... most - 1
            ++upperChange[least], --upperChange[own];
        }
        Cut best;
        const int count = end - begin;
        int below = 0, fromLower = 0, fromUpper = 0;
        for (int bin = 0; bin + 1 < bins; ++bin) {
            below += inBin[bin];
            fromLower += lowerChange[bin];
            fromUpper += upperChange[bin];
            for (const bool lower : {true, false}) {
                const int parting = lower ? fromLower : fromUpper;
                const int first = lower ? below - parting : below, second = count - first - parting;
                const double share = static_cast<double>(std::min(first, second)) / count;
                if (share < leastShare)
                    continue;
                const double cost = parting / std::sqrt(share); // few, but not at one end
                if (cost < best.cost)
                    best = {cost, bin, lower};
            }
        }
        return best;
    }

    /// Orders lower half, upper half, what parts them. Returns where the second and the third begin.
    std::pair<int, int> split(int begin, int end, const Cut& cut)
    {
        const int lowerPart = ++m_parts, upperPart = ++m_parts;
        for (int i = begin; i < end; ++i)
            m_part[m_order[i]] = m_bestBin[m_order[i]] <= cut.bin ? lowerPart : upperPart;
        const int own = cut.fromLower ? lowerPart : upperPart, other = cut.fromLower ? upperPart : lowerPart;
        for (int i = begin; i < end; ++i) {
            bool touches = false;
            if (m_part[m_order[i]] == own)
                eachNeighbour(m_order[i], [&](int n) { touches = touches || m_part[n] == other; });
            m_parting[m_order[i]] = touches;
        }
        const auto parting = std::stable_partition(m_order.begin() + begin, m_order.begin() + end,
                                                   [this](int v) { return !m_parting[v]; });
        const auto middle =
            std::stable_partition(m_order.begin() + begin, parting, [&](int v) { return m_part[v] == lowerPart; });
        for (auto v = parting; v != m_order.begin() + end; ++v)
            m_part[*v] = 0;
        return {static_cast<int>(middle - m_order.begin()), static_cast<int>(parting - m_order.begin())};
    }

    template <class Visit>
    void eachNeighbour(int vertex, Visit visit) const
    {
        for (int k = m_graph.start[vertex]; k < m_graph.start[vertex + 1]; ++k)
            visit(m_graph.neighbour[k]);
    }

    using Vec = Eigen::Vector3d;

    const Adjacency& m_graph;
    const Eigen::Matrix3Xd& m_places;
    const std::stop_token& m_stop;
    std::vector<int> m_order;
    std::vector<int> m_part; // which part an unknown lies in now; 0 when its place is settled
    int m_parts = 0;
    std::vector<int> m_bin, m_bestBin;
    std::vector<char> m_parting;
    std::vector<int> m_queue;
};

} // namespace

std::vector<int> nestedDissection(const Eigen::SparseMatrix<double>& lower, const Eigen::Matrix3Xd& places,
                                  const std::stop_token& stop)
{
    return Dissection(Adjacency(lower), places, stop).run();
}

} // namespace bolster
