#include "FoldSeeds.h"

#include "Rims.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace bolster {

namespace {

/// The in-plane stretches at a vertex, minus 1, the smaller one first.
std::array<double, 2> principalStrains(const SewnMesh& mesh, const SheetState& state, int v)
{
    Eigen::Matrix<double, 3, 2> covariance = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Matrix2d rest = 1e-4 * mesh.area[v] * Eigen::Matrix2d::Identity();
    const auto& unknown = mesh.topology->unknown;
    for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
        const SewnMesh::RingEdge& edge = mesh.ring[k];
        const Vec3 e = state.positions.col(unknown[edge.vertex]) - state.positions.col(unknown[v]);
        const Vec2 there = mesh.along(v, edge);
        covariance += edge.weight * e * there.transpose();
        rest += edge.weight * there * there.transpose();
    }
    const Eigen::Matrix<double, 3, 2> gradient = covariance * rest.inverse();
    const Eigen::Matrix2d square = gradient.transpose() * gradient;
    const double half = 0.5 * square.trace();
    const double root = std::sqrt(std::max(0.0, half * half - square.determinant()));
    return {std::sqrt(std::max(0.0, half - root)) - 1, std::sqrt(half + root) - 1};
}

/// A smooth ripple within +-1: waves in directions and of lengths that have no common measure.
double ripple(const Vec2& p, double wavelength)
{
    const Vec2 q = p * (2 * EIGEN_PI / wavelength);
    return (std::sin(q.x() + 0.3) + std::sin(0.62 * q.x() + 0.79 * q.y() + 1.1) +
            std::sin(0.55 * q.x() - 0.97 * q.y() + 2.3) + std::sin(1.31 * q.y() + 0.7)) /
           4;
}

constexpr double leastPressed = 0.002; // strain at which cloth counts as compressed

/// Of vertices inside a patch that move; else none.
std::array<double, 2> strainsAt(const SewnMesh& mesh, const SheetState& state, int v)
{
    return static_cast<int>(mesh.topology->unknown[v]) < mesh.freeCount ? principalStrains(mesh, state, v)
                                                                        : std::array{0.0, 0.0};
}

/// How a component lies, and how it is pressed together.
struct Flatness {
    Vec3 sum = Vec3::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double vertices = 0;
    double most = 0;    ///< that cloth is pressed together inside, 1
    double pressed = 0; ///< area of what is pressed together, and the larger strains there times it
    double larger = 0;

    /// Standard deviation across the plane that it lies in, mm.
    double thickness() const
    {
        const Vec3 mean = sum / std::max(vertices, 1.0);
        const Eigen::Matrix3d spread = squares / std::max(vertices, 1.0) - mean * mean.transpose();
        return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues()[0]));
    }
};

/// Which components lie nearly in a plane and are too large for their room there, in both directions or hardly.
/// What is much too wide in one direction folds in many ways, which the ripple decides.
std::vector<bool> rising(const SewnMesh& mesh, const SheetState& state)
{
    constexpr double thinnest = 0.02;     // of D
    constexpr double mostSlack = 0.06;    // strain
    constexpr double pressedBoth = 0.003; // strain: the larger one, on the average of what is pressed together
    std::vector<Flatness> all(mesh.diameter.size());
    for (const SewnMesh::Part& part : mesh.parts) {
        Flatness& component = all[part.component];
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const Vec3 place = state.positions.col(mesh.topology->unknown[v]) - state.positions.col(0);
            component.sum += place;
            component.squares += place * place.transpose();
            component.vertices += 1;
            if (v < part.firstVertex + part.boundaryCount)
                continue;
            const auto [least, larger] = strainsAt(mesh, state, v);
            component.most = std::max(component.most, -least);
            if (-least > leastPressed) {
                component.pressed += mesh.area[v];
                component.larger += mesh.area[v] * larger;
            }
        }
    }
    std::vector<bool> result;
    for (std::size_t c = 0; c < all.size(); ++c)
        result.push_back(all[c].thickness() < thinnest * mesh.diameter[c] && all[c].pressed > 0 &&
                         (all[c].larger < -pressedBoth * all[c].pressed || all[c].most < mostSlack));
    return result;
}

/// How high each unknown stands on what holds its component, mm: along the shortest way from there cloth keeps its
/// length, and what the place it lies at leaves of that goes up.
std::vector<double> heights(const SewnMesh& mesh, const SheetState& state)
{
    const auto& unknown = mesh.topology->unknown;
    std::vector<double> way(mesh.unknownCount(), std::numeric_limits<double>::infinity()), height(way.size(), 0);
    std::vector<std::vector<int>> sharing(way.size());
    for (int v = 0; v < mesh.vertexCount(); ++v)
        sharing[unknown[v]].push_back(v);
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> waiting;
    for (int u = mesh.freeCount; u < mesh.unknownCount(); ++u)
        waiting.emplace(way[u] = 0, u);
    while (!waiting.empty()) {
        const auto [far, u] = waiting.top();
        waiting.pop();
        if (far > way[u])
            continue;
        for (const int v : sharing[u])
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
                const auto other = unknown[mesh.ring[k].vertex];
                const double length = mesh.along(v, mesh.ring[k]).norm();
                if (far + length >= way[other])
                    continue;
                const double there = (state.positions.col(other) - state.positions.col(u)).squaredNorm();
                way[other] = far + length;
                height[other] = height[u] + std::sqrt(std::max(0.0, length * length - there));
                waiting.emplace(way[other], static_cast<int>(other));
            }
    }
    return height;
}

/// The pattern of a dome, or of a box, within its rim: each place as high above it as its cloth reaches. Momentum
/// carried what began a little above the rim's plane through it.
void standUp(const SewnMesh& mesh, const std::vector<bool>& rises, SheetState& state)
{
    if (std::ranges::count(rises, true) == 0)
        return;
    const std::vector<Rim> rims = rimsOf(mesh);
    const std::vector<double> height = heights(mesh, state);
    std::vector<Vec3> up(height.size(), Vec3::Zero());
    for (const SewnMesh::Part& part : mesh.parts)
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
            if (rises[part.component])
                up[mesh.topology->unknown[v]] = rims[part.component].up;
    for (int u = 0; u < mesh.freeCount; ++u)
        if (up[u] != Vec3::Zero()) // there may be nothing that holds it
            state.positions.col(u) += height[u] * up[u];
}

} // namespace

void seedFolds(const SewnMesh& mesh, SheetState& state)
{
    constexpr double height = 0.002;   // of D
    constexpr double wavelength = 0.2; // of D
    constexpr double full = 0.02;
    constexpr double lift =
        0.006; // of D to the outside: a dome has no part in a ripple, and symmetry keeps it flat
    const std::vector<bool> rises = rising(mesh, state);
    standUp(mesh, rises, state);
    for (const SewnMesh::Part& part : mesh.parts) {
        const double d = mesh.diameter[part.component];
        for (int v = part.firstVertex + part.boundaryCount; v < part.firstVertex + part.vertexCount; ++v) {
            const double compression = -strainsAt(mesh, state, v)[0];
            if (compression <= leastPressed)
                continue;
            const double share = std::min(1.0, (compression - leastPressed) / (full - leastPressed));
            const Eigen::Vector3d normal = rotationOf(state.frames.col(v)).col(2);
            auto place = state.positions.col(mesh.topology->unknown[v]);
            place += share * height * d * ripple(mesh.rest()[v], wavelength * d) * normal;
            if (rises[part.component]) // all of it: near the least slack the dome grows slowly
                place += lift * d * part.outward * normal;
        }
    }
}

} // namespace bolster
