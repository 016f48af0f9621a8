#include "SheetOptimizer.h"

#include "FrameSigns.h"
#include "LocalStep.h"
#include "Orientations.h"
#include "PatternWarp.h"
#include "SheetMatrices.h"
#include "StartPlacement.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

// Below 4/3, see stableStep().
constexpr double stableGain = 1.3;
// Of the rest shape against that in the matrices, below 4/3 for L2, too.
constexpr double mostDistortion = 1.2;
// A vertex further out than this many D has been thrown away by an instability.
constexpr double farthest = 1e4;

} // namespace

SheetOptimizer::SheetOptimizer(const SewnMesh& mesh, WorkerPool& pool, Ghosts ghosts, const std::stop_token& stop)
    : m_mesh(mesh)
    , m_pool(pool)
    , m_ghosts(std::move(ghosts))
    , m_rings(mesh)
{
    precomputeRings();
    updateGhostWeights();
    // Where patches lie to begin with is good enough to tell what is near what, and the same on every run.
    const Eigen::Matrix3Xd places = startPlacement(mesh).positions;
    std::array<Eigen::SparseMatrix<double>, 2> matrices;
    pool.forTasks(2, [&](int system) {
        if (stop.stop_requested())
            return;
        matrices[system] = system == 0 ? positionMatrix(mesh, ghostWeights()) : frameMatrix(mesh, frameRows());
        if (system == 0)
            m_positions.emplace(matrices[0], places.leftCols(mesh.freeCount));
        else
            m_frames.emplace(matrices[1], places(Eigen::all, mesh.topology->unknown));
    });
    if (!stop.stop_requested())
        m_positions->factor(matrices[0], pool, stop) && m_frames->factor(matrices[1], pool, stop);
}

bool SheetOptimizer::refactor()
{
    m_smoothSeams.emplace(m_mesh, m_rest);
    m_factored = m_mesh.rest();
    m_distortion = 1;
    return m_positions->factor(positionMatrix(m_mesh, ghostWeights()), m_pool) &&
           m_frames->factor(frameMatrix(m_mesh, frameRows()), m_pool);
}

bool SheetOptimizer::reshape()
{
    m_rings = SheetRings(m_mesh);
    measureRings();
    m_distortion = distortion(m_mesh.topology->triangles, m_factored, m_mesh.rest());
    return m_distortion < mostDistortion ? ok() : refactor();
}

/// What smooth seams and held normals add to L2's diagonal.
std::vector<double> SheetOptimizer::frameRows() const
{
    std::vector<double> rows = m_smoothSeams->damping();
    for (const SewnMesh::Oriented& held : m_mesh.oriented)
        rows[held.vertex] += orientationWeight(m_mesh, held);
    return rows;
}

bool SheetOptimizer::replaceGhosts(Ghosts ghosts)
{
    m_ghosts = std::move(ghosts);
    return updateGhostWeights();
}

bool SheetOptimizer::setFitting(bool on)
{
    m_fitting = on;
    return updateGhostWeights();
}

/// False when they are no longer those in the matrix.
bool SheetOptimizer::updateGhostWeights()
{
    std::vector<double> gammas;
    for (const SewnMesh::Part& part : m_mesh.parts) {
        double gamma = 0;
        for (const auto& source : m_ghosts)
            gamma += acts(*source) ? source->gamma(part) : 0;
        gammas.push_back(gamma);
    }
    return std::exchange(m_gammas, std::move(gammas)) == m_gammas;
}

/// Of all sources, per part: gamma / D^2.
std::vector<double> SheetOptimizer::ghostWeights() const
{
    std::vector<double> weights;
    for (std::size_t p = 0; p < m_mesh.parts.size(); ++p) {
        const double d = m_mesh.diameter[m_mesh.parts[p].component];
        weights.push_back(m_gammas[p] / (d * d));
    }
    return weights;
}

void SheetOptimizer::precomputeRings()
{
    const int vertices = m_mesh.vertexCount();
    m_partOf.resize(vertices);
    for (int p = 0; p < std::ssize(m_mesh.parts); ++p)
        std::fill_n(m_partOf.begin() + m_mesh.parts[p].firstVertex, m_mesh.parts[p].vertexCount, p);
    measureRings();
    m_factored = m_mesh.rest();

    m_cornersStart.assign(m_mesh.freeCount + 1, 0);
    const auto& unknown = m_mesh.topology->unknown;
    for (int v = 0; v < vertices; ++v)
        if (static_cast<int>(unknown[v]) < m_mesh.freeCount)
            ++m_cornersStart[unknown[v] + 1];
    for (int u = 0; u < m_mesh.freeCount; ++u)
        m_cornersStart[u + 1] += m_cornersStart[u];
    m_corners.resize(m_cornersStart.back());
    std::vector<int> next(m_cornersStart.begin(), m_cornersStart.end() - 1);
    for (int v = 0; v < vertices; ++v)
        if (static_cast<int>(unknown[v]) < m_mesh.freeCount)
            m_corners[next[unknown[v]]++] = v;

    m_map.setZero(4, 2 * vertices);
    m_stretch.setZero(4, vertices);
    m_forces.setZero(4, vertices);
    m_displacements.setZero(4, vertices);
    m_frameRight.setZero(4, vertices);
    m_residual.setZero(4, m_mesh.freeCount);
    m_turns.setZero(4, vertices);
    m_moves.setZero(4, m_mesh.freeCount);
}

/// All that depends on the rest shape but the matrices.
void SheetOptimizer::measureRings()
{
    m_rest.assign(m_mesh.vertexCount(), Eigen::Matrix2d::Zero());
    for (int v = 0; v < m_mesh.vertexCount(); ++v)
        for (int k = m_mesh.ringStart[v]; k < m_mesh.ringStart[v + 1]; ++k)
            m_rest[v] += m_mesh.ring[k].weight * m_mesh.ring[k].rest * m_mesh.ring[k].rest.transpose();
    m_smoothSeams.emplace(m_mesh, m_rest);
    m_freeBodies.clear();
    for (int c = 0; c < std::ssize(m_mesh.anchored); ++c)
        if (!m_mesh.anchored[c])
            m_freeBodies.emplace_back(m_mesh, c);
}

/// Calls body(part, begin, end) for runs of vertices of one part each, on all threads.
template <class Body>
void SheetOptimizer::forParts(const Body& body)
{
    m_pool.forChunks(m_mesh.vertexCount(), [&](int, int begin, int end) {
        while (begin < end) {
            const SewnMesh::Part& part = m_mesh.parts[m_partOf[begin]];
            const int stop = std::min(end, part.firstVertex + part.vertexCount);
            body(part, begin, stop);
            begin = stop;
        }
    });
}

SheetState SheetOptimizer::state() const
{
    return {m_state.positions.topRows<3>(), m_state.frames};
}

void SheetOptimizer::report(SolveReport& report) const
{
    for (const auto& source : m_ghosts)
        source->report({m_mesh, m_state.positions, m_state.frames}, report);
}

void SheetOptimizer::restart(SheetState state)
{
    m_state.positions.setZero(4, state.positions.cols());
    m_state.positions.topRows<3>() = state.positions;
    m_state.frames = std::move(state.frames);
    m_ahead = m_state;
    retarget();
}

void SheetOptimizer::retarget()
{
    for (std::size_t k = 0; k < m_mesh.targets.size(); ++k)
        m_state.positions.col(m_mesh.freeCount + static_cast<Eigen::Index>(k)).head<3>() = m_mesh.targets[k];
    m_before = m_state;
    m_next = m_state;
    m_momentum = 1;
    m_signsAgree = false;
}

void SheetOptimizer::relaxPositions()
{
    m_ahead = m_state;
    m_next.frames = m_state.frames;
    for (int v = 0; v < m_mesh.vertexCount(); ++v)
        m_map.middleCols<2>(2 * v).topRows<3>() = rotationOf(m_state.frames.col(v)).leftCols<2>();
    solvePositions(1);
    m_state = m_next;
    m_before = m_state;
    m_momentum = 1;
}

std::optional<double> SheetOptimizer::iterate()
{
    if (!m_signsAgree)
        alignSigns(m_mesh, m_pool, m_state.frames);
    extrapolate();
    fit();
    solveFrames();
    solvePositions(stableStep());
    return accept();
}

/// Nesterov's step ahead along the last move, frames included.
void SheetOptimizer::extrapolate()
{
    const double momentum = 0.5 * (1 + std::sqrt(1 + 4 * m_momentum * m_momentum));
    const double beta = m_accelerated ? (m_momentum - 1) / momentum : 0;
    m_momentum = momentum;
    m_pool.forChunks(m_mesh.unknownCount(), [&](int, int begin, int end) {
        for (int u = begin; u < end; ++u)
            m_ahead.positions.col(u) =
                m_state.positions.col(u) + beta * (m_state.positions.col(u) - m_before.positions.col(u));
    });
    m_pool.forChunks(m_mesh.vertexCount(), [&](int, int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const Eigen::Vector4d now = m_state.frames.col(v), before = m_before.frames.col(v);
            const double sign = now.dot(before) < 0 ? -1 : 1;
            m_ahead.frames.col(v) = ((1 + beta) * now - sign * beta * before).normalized();
        }
    });
}

/// The local step.
void SheetOptimizer::fit()
{
    forParts([&](const SewnMesh::Part& part, int begin, int end) {
        fitFrames(m_rings, m_ahead.positions, m_ahead.frames, part.material.poisson, begin, end, m_frameRight,
                  m_stretch);
    });
    const SheetView now{m_mesh, m_ahead.positions, m_ahead.frames};
    m_smoothSeams->correct(now, m_pool, m_frameRight);
    addOrientations(now, m_frameRight);
}

/// L2 in delta form.
void SheetOptimizer::solveFrames()
{
    const std::vector<int>& slots = m_frames->slots();
    std::atomic<bool> agree = true;
    forParts([&](const SewnMesh::Part& part, int begin, int end) {
        if (!frameResiduals(m_rings, m_ahead.frames, m_frameRight, 2 * part.bendingSquared(), begin, end, slots,
                            m_turns))
            agree.store(false, std::memory_order_relaxed);
    });
    m_signsAgree = agree;
    m_frames->solve(m_turns, m_pool);
    forParts([&](const SewnMesh::Part&, int begin, int end) {
        turnFrames(m_ahead.frames, m_turns, slots, m_stretch, begin, end, m_next.frames, m_map);
    });
}

/// Share of L1's move that may be made. The preferred stretch answers strain with up to 1 + |nu| times of it (pure
/// shear for nu < 0, dilation for nu > 0), and forces of a distorted rest shape exceed those in the matrix, but an
/// accelerated iteration diverges beyond 4/3.
double SheetOptimizer::stableStep() const
{
    double poisson = 0;
    for (const SewnMesh::Part& part : m_mesh.parts)
        poisson = std::max(poisson, std::abs(part.material.poisson));
    return std::min(1.0, stableGain / ((1 + poisson) * m_distortion));
}

/// L1 in delta form: the residual at the present positions, then `step` times the move that it asks for.
void SheetOptimizer::solvePositions(double step)
{
    forParts([&](const SewnMesh::Part& part, int begin, int end) {
        ringForces(m_rings, m_ahead.positions, m_map, part.material.stiffness, begin, end, m_forces);
    });
    addGhosts();
    m_pool.forChunks(m_mesh.freeCount, [&](int, int begin, int end) {
        for (int u = begin; u < end; ++u) {
            Eigen::Vector4d residual = Eigen::Vector4d::Zero();
            for (int c = m_cornersStart[u]; c < m_cornersStart[u + 1]; ++c) {
                residual += m_forces.col(m_corners[c]);
                addPressure(m_corners[c], residual);
            }
            m_residual.col(u) = residual;
        }
    });
    for (const FreeBody& body : m_freeBodies)
        body.balance(m_ahead.positions, m_residual);
    if (m_mesh.freeCount == 0)
        return;
    const std::vector<int>& slots = m_positions->slots();
    m_pool.forChunks(m_mesh.freeCount, [&](int, int begin, int end) {
        for (int u = begin; u < end; ++u)
            m_moves.col(slots[u]) = m_residual.col(u).cast<float>();
    });
    m_positions->solve(m_moves, m_pool);
    m_pool.forChunks(m_mesh.freeCount, [&](int, int begin, int end) {
        for (int u = begin; u < end; ++u)
            m_next.positions.col(u) = m_ahead.positions.col(u) + step * m_moves.col(slots[u]).cast<double>();
    });
}

void SheetOptimizer::addGhosts()
{
    const SheetView sheet{m_mesh, m_ahead.positions, m_next.frames};
    for (const auto& source : m_ghosts) {
        if (!acts(*source))
            continue;
        source->follow(sheet, m_pool);
        forParts([&](const SewnMesh::Part& part, int begin, int end) {
            const double d = m_mesh.diameter[part.component];
            const double weight = source->gamma(part) / (d * d);
            if (weight == 0)
                return;
            source->displace(sheet, part, begin, end, m_displacements);
            for (int v = begin; v < end; ++v)
                m_forces.col(v) += weight * m_mesh.area[v] * m_displacements.col(v);
        });
    }
}

void SheetOptimizer::addPressure(int vertex, Eigen::Vector4d& residual) const
{
    const SewnMesh::Part& part = m_mesh.parts[m_partOf[vertex]];
    const double pressure = part.material.pressure;
    if (pressure == 0)
        return;
    const Vec3 normal = SheetView{m_mesh, m_ahead.positions, m_next.frames}.outside(part, vertex);
    residual.head<3>() += (pressure * m_mesh.area[vertex] / m_mesh.diameter[part.component]) * normal;
}

/// Measures the move, restarts the acceleration when it has overshot, and makes the new state the present one.
std::optional<double> SheetOptimizer::accept()
{
    struct Sums {
        double overshoot = 0;
        double farthestMove = 0; // squared, relative to D
        bool bounded = true;
    };
    std::vector<Sums> sums(WorkerPool::chunkCount(m_mesh.freeCount));
    const double bound = farthest * m_mesh.largestDiameter();
    m_pool.forChunks(m_mesh.freeCount, [&](int chunk, int begin, int end) {
        Sums s;
        for (int u = begin; u < end; ++u) {
            const Eigen::Vector4d next = m_next.positions.col(u);
            const Eigen::Vector4d move = next - m_state.positions.col(u);
            const double d = m_mesh.diameter[m_mesh.parts[m_partOf[m_corners[m_cornersStart[u]]]].component];
            s.overshoot += (m_ahead.positions.col(u) - next).dot(move);
            s.farthestMove = std::max(s.farthestMove, move.squaredNorm() / (d * d));
            s.bounded = s.bounded && next.cwiseAbs().maxCoeff() < bound + m_state.positions.col(u).norm();
        }
        sums[chunk] = s;
    });
    Sums total;
    for (const Sums& s : sums) {
        total.overshoot += s.overshoot;
        total.farthestMove = std::max(total.farthestMove, s.farthestMove);
        total.bounded = total.bounded && s.bounded;
    }
    if (!total.bounded || !std::isfinite(total.overshoot))
        return std::nullopt;
    std::swap(m_before, m_state);
    std::swap(m_state, m_next);
    if (total.overshoot > 0)
        m_momentum = 1;
    return std::sqrt(total.farthestMove);
}

} // namespace bolster
