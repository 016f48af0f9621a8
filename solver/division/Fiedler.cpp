#include "Fiedler.h"

#include "HalfEdges.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace bolster {

namespace {

constexpr int mostIterations = 2000;
constexpr Eigen::Index fewEnough = 20'000; // to be solved at once
constexpr int roundsOfRelaxing = 10;
constexpr double settled = 1e-9;   // of the vector: a round that changes it less is the last one
constexpr double leastShare = 0.1; // of the area on either side

/// What two neighbouring triangles have in common.
struct Bond {
    int a, b;
    double strength;
};

/// Triangles, or bunches of them.
struct Graph {
    Eigen::VectorXd areas;   ///< mm^2
    Eigen::VectorXd heights; ///< mm, somewhere along the sheet
    std::vector<Bond> bonds;
};

using Centers = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Along a direction of the sheet's own, which turns with it: like sheets shall be halved alike. Not along an axis,
/// where symmetry would keep it from finding any other one.
Eigen::VectorXd ownHeights(Centers centers, const Eigen::VectorXd& areas)
{
    const Eigen::RowVector3d middle = areas.transpose() * centers / areas.sum();
    centers.rowwise() -= middle;
    const Eigen::Matrix3d spread = centers.transpose() * areas.asDiagonal() * centers;
    Centers along = centers * Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
    for (Eigen::Index axis = 0; axis < 3; ++axis) // an axis has no sign but by where the sheet reaches farther
        if (areas.dot(along.col(axis).array().cube().matrix()) < 0)
            along.col(axis) *= -1;
    return along * Vec3(0.4, 0.7, 1);
}

/// Bonds are as strong as the edge is long over the way from center to center, on which a bend counts as an arc of
/// the sheet's size.
Graph graphOf(const FormSheet& sheet, const std::stop_token& stop)
{
    Graph graph;
    graph.areas.resize(std::ssize(sheet.triangles));
    Centers centers(std::ssize(sheet.triangles), 3);
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        graph.areas[static_cast<Eigen::Index>(t)] = std::max(sheet.areaNormal(t).norm(), 1e-9);
        centers.row(static_cast<Eigen::Index>(t)) = sheet.center(t);
    }
    graph.heights = ownHeights(centers, graph.areas);
    const double size = std::sqrt(graph.areas.sum());
    const std::vector<HalfEdge> halves = halfEdges(sheet.triangles, stop);
    if (stop.stop_requested())
        return graph;
    eachEdge(halves, [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first != 2)
            return;
        const Vec3 &from = sheet.points[first->low], &to = sheet.points[first->high];
        const Vec3 middle = (from + to) / 2, one = sheet.areaNormal(first[0].triangle),
                   other = sheet.areaNormal(first[1].triangle);
        const double bend = std::atan2(one.cross(other).norm(), one.dot(other));
        const double way = (sheet.center(first[0].triangle) - middle).norm() +
                           (sheet.center(first[1].triangle) - middle).norm() + size * bend;
        graph.bonds.push_back({first[0].triangle, first[1].triangle, (to - from).norm() / std::max(way, 1e-6)});
    });
    return graph;
}

/// With pairs that are bound most strongly as one. `bunch`: which one each has become.
Graph coarser(const Graph& fine, std::vector<int>& bunch)
{
    std::vector<Bond> bonds = fine.bonds;
    std::ranges::stable_sort(bonds, std::greater<>(), &Bond::strength);
    bunch.assign(static_cast<std::size_t>(fine.areas.size()), -1);
    int count = 0;
    for (const Bond& bond : bonds)
        if (bunch[bond.a] < 0 && bunch[bond.b] < 0)
            bunch[bond.a] = bunch[bond.b] = count++;
    for (int& each : bunch)
        if (each < 0)
            each = count++;
    Graph coarse{Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count), {}};
    for (Eigen::Index t = 0; t < fine.areas.size(); ++t) {
        const int to = bunch[static_cast<std::size_t>(t)];
        coarse.areas[to] += fine.areas[t];
        coarse.heights[to] += fine.areas[t] * fine.heights[t];
    }
    coarse.heights.array() /= coarse.areas.array();
    std::map<std::pair<int, int>, double> sums;
    for (const Bond& bond : fine.bonds)
        if (bunch[bond.a] != bunch[bond.b])
            sums[std::minmax(bunch[bond.a], bunch[bond.b])] += bond.strength;
    for (const auto& [pair, strength] : sums)
        coarse.bonds.push_back({pair.first, pair.second, strength});
    return coarse;
}

/// The second eigenvector of the bonds' Laplacian against areas, by inverse iteration from the heights. None when
/// it cannot be found, or stopped.
std::optional<Eigen::VectorXd> fiedlerVector(const Graph& graph, const std::stop_token& stop)
{
    const Eigen::Index count = graph.areas.size();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd diagonal = graph.areas / graph.areas.sum() * 1e-4; // else it had no inverse
    for (const Bond& bond : graph.bonds) {
        entries.emplace_back(bond.a, bond.b, -bond.strength);
        entries.emplace_back(bond.b, bond.a, -bond.strength);
        diagonal[bond.a] += bond.strength;
        diagonal[bond.b] += bond.strength;
    }
    for (Eigen::Index t = 0; t < count; ++t)
        entries.emplace_back(t, t, diagonal[t]);
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success)
        return std::nullopt;
    const auto normalize = [&](Eigen::VectorXd& x) {
        x.array() -= graph.areas.dot(x) / graph.areas.sum();
        x /= std::sqrt(std::max(graph.areas.dot(x.cwiseAbs2()), 1e-300));
    };
    Eigen::VectorXd vector = graph.heights;
    normalize(vector);
    for (int round = 0; round < mostIterations; ++round) {
        if (stop.stop_requested())
            return std::nullopt;
        Eigen::VectorXd next = factor.solve(graph.areas.cwiseProduct(vector));
        normalize(next);
        const double change = std::sqrt(graph.areas.dot((next - vector).cwiseAbs2()));
        vector = std::move(next);
        if (change < settled)
            break;
    }
    return vector.allFinite() ? std::optional(vector) : std::nullopt;
}

/// Each becomes what those are that it is bound to, by the strengths of their bonds.
void relax(const Graph& graph, Eigen::VectorXd& value)
{
    for (int round = 0; round < roundsOfRelaxing; ++round) {
        Eigen::VectorXd sums = Eigen::VectorXd::Zero(value.size()), strengths = sums;
        for (const Bond& bond : graph.bonds) {
            sums[bond.a] += bond.strength * value[bond.b];
            sums[bond.b] += bond.strength * value[bond.a];
            strengths[bond.a] += bond.strength;
            strengths[bond.b] += bond.strength;
        }
        value = (strengths.array() > 0).select((value + sums.cwiseQuotient(strengths)) / 2, value);
    }
}

/// Fiedler's vector, found for bunches where triangles are many.
std::optional<Eigen::VectorXd> orderAlong(const Graph& graph, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return std::nullopt;
    if (graph.areas.size() <= fewEnough)
        return fiedlerVector(graph, stop);
    std::vector<int> bunch;
    const Graph coarse = coarser(graph, bunch);
    if (coarse.areas.size() > 0.9 * static_cast<double>(graph.areas.size())) // it hardly hangs together
        return fiedlerVector(graph, stop);
    const std::optional<Eigen::VectorXd> found = orderAlong(coarse, stop);
    if (!found)
        return std::nullopt;
    Eigen::VectorXd value(graph.areas.size());
    for (Eigen::Index t = 0; t < value.size(); ++t)
        value[t] = (*found)[bunch[static_cast<std::size_t>(t)]];
    relax(graph, value);
    return value;
}

/// Where the parts below and above have the least in common for their size.
double bestThreshold(const Graph& graph, const Eigen::VectorXd& value)
{
    const auto count = static_cast<std::size_t>(value.size());
    std::vector<std::vector<std::pair<int, double>>> beside(count);
    for (const Bond& bond : graph.bonds) {
        beside[bond.a].emplace_back(bond.b, bond.strength);
        beside[bond.b].emplace_back(bond.a, bond.strength);
    }
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int t) { return value[t]; });
    const double all = graph.areas.sum();
    std::vector<bool> below(count, false);
    double area = 0, cut = 0, least = std::numeric_limits<double>::infinity(), best = 0;
    for (std::size_t k = 0; k + 1 < count; ++k) {
        const int t = order[k];
        below[t] = true;
        area += graph.areas[t];
        for (const auto& [other, strength] : beside[t])
            cut += below[other] ? -strength : strength;
        const double smaller = std::min(area, all - area);
        if (smaller >= leastShare * all && cut / smaller < least) {
            least = cut / smaller;
            best = (value[t] + value[order[k + 1]]) / 2;
        }
    }
    return best;
}

/// Of each point: the mean of the triangles around it.
std::vector<double> atPoints(const FormSheet& sheet, const Eigen::VectorXd& value)
{
    std::vector<double> sums(sheet.points.size(), 0), areas(sheet.points.size(), 0);
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        const double area = sheet.areaNormal(t).norm();
        for (const int corner : sheet.triangles[t]) {
            sums[corner] += area * value[static_cast<Eigen::Index>(t)];
            areas[corner] += area;
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
        sums[v] /= std::max(areas[v], 1e-300);
    return sums;
}

} // namespace

Halves halvesOf(const FormSheet& sheet, const std::stop_token& stop)
{
    const Graph graph = graphOf(sheet, stop);
    std::optional<Eigen::VectorXd> value = orderAlong(graph, stop);
    if (!value)
        return {};
    value->array() -= bestThreshold(graph, *value);
    return {{value->begin(), value->end()}, atPoints(sheet, *value)};
}

} // namespace bolster
