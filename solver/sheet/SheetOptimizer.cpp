#include "SheetOptimizer.h"

#include "FrameSigns.h"
#include "LocalStep.h"
#include "Orientations.h"
#include "PatternWarp.h"
#include "SheetMatrices.h"
#include "SolveReport.h"
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
// Of a move without acceleration: beside sharply bent smooth seams a whole one can overshoot by as much again, and
// the next one go all the way back.
constexpr double plainShare = 0.5;

} // namespace

SheetOptimizer::SheetOptimizer(const SewnMesh& mesh, WorkerPool& pool, Ghosts ghosts, const std::stop_token& stop)
    : m_mesh(mesh)
    , m_pool(pool)
    , m_ghosts(std::move(ghosts))
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
    if (stop.stop_requested())
        return;
    numberSlots();
    m_positions->factor(matrices[0], pool, stop) && m_frames->factor(matrices[1], pool, stop);
}

bool SheetOptimizer::refactor()
{
    m_smoothSeams.emplace(m_mesh, m_rest);
    return factor();
}

bool SheetOptimizer::factor()
{
    ++m_factorings;
    m_factored = m_mesh.rest();
    m_distortion = 1;
    return m_positions->factor(positionMatrix(m_mesh, ghostWeights()), m_pool) &&
           m_frames->factor(frameMatrix(m_mesh, frameRows()), m_pool);
}

bool SheetOptimizer::reshape()
{
    measureRings();
    m_distortion = distortion(m_mesh.topology->triangles, m_factored, m_mesh.rest(), m_pool);
    return m_distortion < mostDistortion ? ok() : factor();
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

    m_map.setZero(4, 2 * vertices);
    m_forces.setZero(4, vertices);
    m_stretch.setZero(4, vertices);
    m_moved.resize(WorkerPool::chunkCount(m_mesh.freeCount));
}

/// When both systems are there.
void SheetOptimizer::numberSlots()
{
    const auto& unknown = m_mesh.topology->unknown;
    std::vector<int> count(m_mesh.unknownCount(), 0), merged(m_mesh.unknownCount(), -1);
    for (const std::uint32_t u : unknown)
        ++count[u];
    m_moveSlots.assign(unknown.size(), -1);
    for (std::size_t v = 0; v < unknown.size(); ++v) {
        const int u = static_cast<int>(unknown[v]);
        if (u >= m_mesh.freeCount)
            continue;
        if (count[u] == 1)
            m_moveSlots[v] = m_positions->slots()[u];
        else if (merged[u] < 0) {
            merged[u] = static_cast<int>(m_merged.size());
            const int begin = static_cast<int>(m_corners.size());
            m_merged.push_back({m_positions->slots()[u], begin, begin});
            m_corners.resize(m_corners.size() + count[u]);
        }
        if (merged[u] >= 0)
            m_corners[m_merged[merged[u]].end++] = static_cast<int>(v);
    }
    m_results.turnSlots = m_frames->slots().data();
    m_results.turns = m_frames->x().data();
    m_results.stretch = m_stretch.data();
    m_results.moveSlots = m_moveSlots.data();
    m_results.moves = m_positions->x().data();
    m_results.forces = m_forces.data();
}

/// All that depends on the rest shape but the matrices.
void SheetOptimizer::measureRings()
{
    m_rings.measure(m_mesh, m_pool);
    m_rest.resize(m_mesh.vertexCount());
    m_pool.forChunks(m_mesh.vertexCount(), [&](int, int begin, int end) {
        for (int v = begin; v < end; ++v) {
            m_rest[v].setZero();
            for (int k = m_mesh.ringStart[v]; k < m_mesh.ringStart[v + 1]; ++k) {
                const Vec2 there = m_mesh.along(v, m_mesh.ring[k]);
                m_rest[v] += m_mesh.ring[k].weight * there * there.transpose();
            }
        }
    });
    m_smoothSeams.emplace(m_mesh, m_rest);
    m_freeBodies.clear();
    std::vector<std::vector<int>> parts(m_mesh.anchored.size()); // of each component
    for (int p = 0; p < std::ssize(m_mesh.parts); ++p)
        parts[m_mesh.parts[p].component].push_back(p);
    for (std::size_t c = 0; c < parts.size(); ++c)
        if (!m_mesh.anchored[c])
            m_freeBodies.emplace_back(m_mesh, parts[c]);
    m_scale.resize(m_mesh.freeCount);
    for (int v = 0; v < m_mesh.vertexCount(); ++v)
        if (const auto u = static_cast<int>(m_mesh.topology->unknown[v]); u < m_mesh.freeCount)
            m_scale[u] = std::pow(m_mesh.diameter[m_mesh.parts[m_partOf[v]].component], -2);
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
    return {m_ahead.positions.topRows<3>() + m_back.positions.topRows<3>().cast<double>(),
            (m_ahead.frames + m_back.frames.cast<double>()).colwise().normalized()};
}

double SheetOptimizer::wayFromMark()
{
    Columns now = m_ahead.positions + m_back.positions.cast<double>();
    double farthest = 0;
    for (int u = 0; u < m_mesh.freeCount && m_mark.cols() == now.cols(); ++u)
        farthest = std::max(farthest, m_scale[u] * (now.col(u) - m_mark.col(u)).squaredNorm());
    m_mark = std::move(now);
    return std::sqrt(farthest);
}

void SheetOptimizer::report(SolveReport& report) const
{
    const Columns positions = m_ahead.positions + m_back.positions.cast<double>();
    const SheetMoment now{m_mesh, positions, m_ahead.frames, &m_back.frames};
    for (const auto& source : m_ghosts) {
        for (const SewnMesh::Part& part : m_mesh.parts)
            report.constraints.ghost += acts(*source) && source->gamma(part) > 0 ? part.vertexCount : 0;
        source->report(now, report);
    }
}

void SheetOptimizer::restart(SheetState state)
{
    m_ahead.positions.setZero(4, state.positions.cols());
    m_ahead.positions.topRows<3>() = state.positions;
    m_ahead.frames = std::move(state.frames);
    m_back.positions.setZero(4, m_ahead.positions.cols());
    m_back.frames.setZero(4, m_ahead.frames.cols());
    m_drift.resize(4, 0);
    retarget();
}

void SheetOptimizer::standStill()
{
    constexpr int rounds = 20; // in which frames come to rest where positions don't move
    m_drift.resize(4, 0);
    for (int round = 0; round < rounds; ++round) {
        startHere();
        alignFrames();
        fit();
        solveFrames();
    }
    startHere();
    solvePositions();
    m_drift = m_positions->x();
}

void SheetOptimizer::release()
{
    m_positions.reset();
    m_frames.reset();
    m_mixing = {};
    m_map.resize(4, 0);
    m_forces.resize(4, 0);
    m_stretch.resize(4, 0);
}

void SheetOptimizer::retarget()
{
    startHere();
    for (std::size_t k = 0; k < m_mesh.targets.size(); ++k)
        m_ahead.positions.col(m_mesh.freeCount + static_cast<Eigen::Index>(k)).head<3>() = m_mesh.targets[k];
    m_signsAgree = false;
    findCorrectable();
}

void SheetOptimizer::relaxPositions()
{
    startHere();
    for (int v = 0; v < m_mesh.vertexCount(); ++v)
        m_map.middleCols<2>(2 * v).topRows<3>() = rotationOf(m_ahead.frames.col(v)).leftCols<2>().cast<float>();
    solvePositions();
    movePositions(1);
    startHere();
}

/// Smooth seams and held normals may be others than before.
void SheetOptimizer::findCorrectable()
{
    m_correctable = m_smoothSeams->vertices();
    for (const SewnMesh::Oriented& held : m_mesh.oriented)
        m_correctable.push_back(held.vertex);
    std::ranges::sort(m_correctable);
    m_correctable.erase(std::unique(m_correctable.begin(), m_correctable.end()), m_correctable.end());
    if (!m_correctable.empty())
        m_fitted.resize(4, m_mesh.vertexCount());
    m_results.fitted = m_correctable.empty() ? nullptr : m_fitted.data();
}

std::optional<double> SheetOptimizer::iterate()
{
    if (m_overshot)
        startHere();
    const bool mixes = m_acceleration == Acceleration::Mixing;
    if (!mixes)
        m_momentum = nextMomentum();
    alignFrames();
    fit();
    solveFrames();
    solvePositions();
    if (!mixes || m_mesh.freeCount == 0)
        return movePositions((m_acceleration == Acceleration::None ? plainShare : 1) * stableStep());
    m_mixing.mix(stableStep(), m_pool, m_positions->x());
    return movePositions(1);
}

void SheetOptimizer::alignFrames()
{
    if (!m_signsAgree)
        for (const int v : alignSigns(m_mesh, m_pool, m_ahead.frames))
            m_back.frames.col(v) *= -1;
}

bool SheetOptimizer::setAcceleration(Acceleration acceleration)
{
    if (acceleration == m_acceleration)
        return false;
    startHere();
    m_acceleration = acceleration;
    return true;
}

/// Without acceleration, from the present state.
void SheetOptimizer::startHere()
{
    m_momentum = 1;
    m_overshot = false;
    m_mixing.forget();
    const auto returnTo = [&](Columns& ahead, Eigen::Matrix4Xf& back, int begin, int end) {
        if (begin < end) {
            ahead.middleCols(begin, end - begin) += back.middleCols(begin, end - begin).cast<double>();
            back.middleCols(begin, end - begin).setZero();
        }
    };
    m_pool.forChunks(m_mesh.vertexCount(), [&](int, int begin, int end) {
        returnTo(m_ahead.frames, m_back.frames, begin, end);
        // There are at least as many vertices as unknowns.
        returnTo(m_ahead.positions, m_back.positions, begin, std::min(end, m_mesh.unknownCount()));
    });
}

double SheetOptimizer::nextMomentum() const
{
    return 0.5 * (1 + std::sqrt(1 + 4 * m_momentum * m_momentum));
}

/// Of the step that is being made, the share to go further (Nesterov).
double SheetOptimizer::beta() const
{
    return m_acceleration == Acceleration::Momentum ? (m_momentum - 1) / nextMomentum() : 0;
}

/// The local step, and the residual of L2.
void SheetOptimizer::fit()
{
    std::atomic<bool> agree = true;
    forParts([&](const SewnMesh::Part& part, int begin, int end) {
        if (!fitFrames(m_rings, m_ahead.positions, m_ahead.frames, part.material.poisson, 2 * part.bendingSquared(),
                       begin, end, m_results))
            agree.store(false, std::memory_order_relaxed);
    });
    m_signsAgree = agree;
    if (!m_correctable.empty())
        correctFits();
}

/// At smooth seams and where normals are held.
void SheetOptimizer::correctFits()
{
    const Columns before = m_fitted(Eigen::all, m_correctable);
    const SheetMoment now{m_mesh, m_ahead.positions, m_ahead.frames};
    m_smoothSeams->correct(now, m_pool, m_fitted);
    addOrientations(now, m_fitted);
    PackedFactor::Workspace turns = m_frames->x();
    for (std::size_t k = 0; k < m_correctable.size(); ++k) {
        const int v = m_correctable[k];
        turns.col(m_frames->slots()[v]) +=
            (m_fitted.col(v) - before.col(static_cast<Eigen::Index>(k))).cast<float>();
    }
}

/// L2 in delta form.
void SheetOptimizer::solveFrames()
{
    m_frames->solve(m_pool);
    const double further = beta();
    forParts([&](const SewnMesh::Part&, int begin, int end) {
        turnFrames(further, begin, end, m_results, m_ahead.frames, m_back.frames, m_map);
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

/// L1 in delta form, at the present positions.
void SheetOptimizer::solvePositions()
{
    addOuterForces();
    forParts([&](const SewnMesh::Part& part, int begin, int end) {
        ringForces(m_rings, m_ahead.positions, m_map, part.material.stiffness, begin, end, m_results);
    });
    PackedFactor::Workspace moves = m_positions->x();
    for (const Merged& merged : m_merged) {
        moves.col(merged.slot).setZero();
        for (int c = merged.begin; c < merged.end; ++c)
            moves.col(merged.slot) += m_forces.col(m_corners[c]);
    }
    for (const FreeBody& body : m_freeBodies)
        body.balance(m_ahead.positions, m_positions->slots(), moves);
    if (m_mesh.freeCount > 0)
        m_positions->solve(m_pool);
    if (m_drift.cols() > 0)
        moves -= m_drift;
}

/// Ghosts and pressure.
void SheetOptimizer::addOuterForces()
{
    const bool pressed = std::ranges::any_of(m_mesh.parts, [](const auto& p) { return p.material.pressure != 0; });
    const bool pulled = std::ranges::any_of(m_ghosts, [this](const auto& source) { return acts(*source); });
    m_results.outer = nullptr;
    if (!pressed && !pulled)
        return;
    m_outer.resize(4, m_mesh.vertexCount());
    m_results.outer = m_outer.data();
    const SheetMoment sheet{m_mesh, m_ahead.positions, m_ahead.frames, &m_back.frames};
    if (pulled && m_displacements.cols() == 0)
        m_displacements.setZero(4, m_mesh.vertexCount());
    for (const auto& source : m_ghosts)
        if (acts(*source))
            source->follow(sheet, m_pool);
    forParts([&](const SewnMesh::Part& part, int begin, int end) {
        const double d = m_mesh.diameter[part.component];
        m_outer.middleCols(begin, end - begin).setZero();
        if (part.material.pressure != 0)
            for (int v = begin; v < end; ++v)
                m_outer.col(v).head<3>() = part.material.pressure / d * m_mesh.area[v] * sheet.outside(part, v);
        for (const auto& source : m_ghosts) {
            const double weight = acts(*source) ? source->gamma(part) / (d * d) : 0;
            if (weight == 0)
                continue;
            source->displace(sheet, part, begin, end, m_displacements);
            for (int v = begin; v < end; ++v)
                m_outer.col(v) += weight * m_mesh.area[v] * m_displacements.col(v);
        }
    });
}

/// `step` times the move that L1 asks for. Returns what iterate() does.
std::optional<double> SheetOptimizer::movePositions(double step)
{
    const double further = beta();
    m_pool.forChunks(m_mesh.freeCount, [&](int chunk, int begin, int end) {
        m_moved[chunk] = bolster::movePositions({m_positions->slots().data(), m_scale.data()}, m_results.moves,
                                                step, further, begin, end, m_ahead.positions, m_back.positions);
    });
    Moved total;
    for (const Moved& moved : m_moved) {
        total.overshoot += moved.overshoot;
        total.farthest = std::max(total.farthest, moved.farthest);
        total.bounded = total.bounded && moved.bounded;
    }
    m_overshot = total.overshoot > 0;
    return total.bounded ? std::optional(std::sqrt(total.farthest)) : std::nullopt;
}

} // namespace bolster
