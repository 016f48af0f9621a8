#include "Benchmarks.h"

#include "BendConvergence.h"
#include "CgalPeer.h"
#include "FactoredSystem.h"
#include "PatternDrag.h"
#include "ReadBandwidth.h"
#include "RestingSolve.h"
#include "Rig.h"
#include "SampleScene.h"
#include "Scenes.h"
#include "SheetMatrices.h"
#include "SolvePeers.h"
#include "StartPlacement.h"

#include <memory>
#include <stdexcept>

namespace bolster::bench {

namespace {

// Numbers of vertices.
constexpr int size3k = 3000;
constexpr int size11k = 11094;
constexpr int size45k = 4 * size11k;
constexpr int size180k = 16 * size11k;
constexpr int size700k = 64 * size11k;

const std::string originalArap = "CGAL ORIGINAL_ARAP";
const std::string smoothArap = "CGAL SRE_ARAP";
const std::string fastSmoothArap = "CGAL SRE_ARAP with UMFPACK";

Lap iterations(const std::shared_ptr<Rig>& rig)
{
    return repeated([rig] { rig->iterate(); });
}

Lap iterations(const std::shared_ptr<CgalPeer>& peer)
{
    return repeated([peer] { peer->iterate(1); });
}

/// A square, which has the largest factors.
std::shared_ptr<Rig> bentRig(int vertices)
{
    auto rig = std::make_shared<Rig>(bentStrip(vertices, 450, 450));
    rig->startFlat();
    return rig;
}

Benchmark iteration(std::string name, int vertices)
{
    return {std::move(name), {smoothArap, originalArap, fastSmoothArap}, [vertices] {
                using enum CgalPeer::Energy;
                const auto rig = bentRig(vertices);
                const HeldSurface surface = heldSurface(rig->mesh());
                return std::vector{
                    iterations(rig), iterations(std::make_shared<CgalPeer>(surface, SmoothRotations)),
                    iterations(std::make_shared<CgalPeer>(surface, Original)),
                    iterations(std::make_shared<CgalPeer>(surface, SmoothRotations, CgalPeer::Solver::Umfpack))};
            }};
}

Benchmark iterationAlone(std::string name, int vertices)
{
    Benchmark benchmark{std::move(name), {}, [vertices] { return std::vector{iterations(bentRig(vertices))}; }};
    benchmark.listed = false;
    return benchmark;
}

/// A short strip, because the peers take ever longer on long ones.
Benchmark convergence(std::string name, int vertices)
{
    return {std::move(name), {smoothArap, originalArap}, [vertices] {
                const auto rig = std::make_shared<Rig>(bentStrip(vertices, 120, 1600));
                const HeldSurface surface = heldSurface(rig->mesh());
                return std::vector{convergenceOf(rig), convergenceOf(surface, CgalPeer::Energy::SmoothRotations),
                                   convergenceOf(surface, CgalPeer::Energy::Original)};
            }};
}

/// L1 of a mesh.
struct PositionSystem {
    Eigen::SparseMatrix<double> matrix;
    Eigen::Matrix3Xd places;

    explicit PositionSystem(const SewnMesh& mesh)
        : matrix(positionMatrix(mesh, std::vector<double>(mesh.parts.size(), 0)))
        , places(startPlacement(mesh).positions.leftCols(mesh.freeCount))
    {}
};

std::shared_ptr<FactoredSystem> factored(const PositionSystem& system, WorkerPool& pool)
{
    auto factored = std::make_shared<FactoredSystem>(system.matrix, system.places);
    if (!factored->factor(system.matrix, pool))
        throw std::runtime_error("a benchmark's matrix could not be factored");
    return factored;
}

/// With four right-hand sides, one of which is not needed: they fill a vector register.
Lap ourSolves(const std::shared_ptr<FactoredSystem>& system, const std::shared_ptr<Rig>& rig)
{
    return repeated([system, rig] {
        system->x().setOnes();
        system->solve(rig->pool());
    });
}

Benchmark solve(std::string name, int vertices)
{
    return {std::move(name), {"CHOLMOD simplicial", "CHOLMOD supernodal", "Eigen LDLT"}, [vertices] {
                const auto rig = bentRig(vertices);
                const PositionSystem system(rig->mesh());
                return std::vector{ourSolves(factored(system, rig->pool()), rig),
                                   repeated(solveBy(SolvePeer::CholmodSimplicial, system.matrix)),
                                   repeated(solveBy(SolvePeer::CholmodSupernodal, system.matrix)),
                                   repeated(solveBy(SolvePeer::EigenLdlt, system.matrix))};
            }};
}

/// A row of the paper's Table 1.
Benchmark table(std::string name, double framesPerSecond, std::function<SolveInput()> input)
{
    return {std::move(name),
            {},
            [input = std::move(input)] {
                const auto rig = std::make_shared<Rig>(input());
                rig->reachFit();
                return std::vector{iterations(rig)};
            },
            Benchmark::Published{"paper, GeForce 8800 (2008)", 1000 / framesPerSecond}};
}

/// From triangles to the first iteration.
Benchmark setup(std::string name, int vertices)
{
    return {std::move(name), {}, [vertices] {
                TriangulationCache cache;
                const auto sheet =
                    std::make_shared<PreparedSheet>(*prepareSheet(SolveInput(seat(vertices)), cache));
                std::vector<PatchMesh> meshes;
                for (const auto& outline : sheet->sampling.outlines)
                    meshes.push_back(cache.mesh(outline.patch));
                const auto pool = std::make_shared<WorkerPool>(threads);
                return std::vector{repeated([sheet, meshes, pool] {
                    const SewnMesh mesh = buildSewnMesh(sheet->design, sheet->sampling, meshes, *pool);
                    Relaxation(mesh, *pool, 0).startCanonically();
                })};
            }};
}

Benchmark drag(std::string name, int vertices)
{
    return {std::move(name), {}, [vertices] {
                return std::vector{
                    Lap([drag = std::make_shared<PatternDrag>(seat(vertices))] { return drag->move(); })};
            }};
}

Benchmark release(std::string name, int vertices, PatternDrag::Until until)
{
    return {std::move(name), {}, [vertices, until] {
                return std::vector{Lap([until, drag = std::make_shared<PatternDrag>(seat(vertices))] {
                    for (int move = 0; move < 3; ++move)
                        drag->move();
                    return drag->release(until);
                })};
            }};
}

/// A sample from nothing to rest, as `bolster solve` does it, beside the same on the design's triangles alone and
/// with momentum alone. Edges in mm, 0: the design's.
Benchmark cold(std::string name, const std::string& sample, double edge)
{
    return {std::move(name), {"one level"}, [sample, edge] {
                const auto input = std::make_shared<SolveInput>(sampleScene(sample, edge));
                const auto solve = [input](bool oneLevel) {
                    return repeated([input, oneLevel] {
                        SolveOptions options;
                        options.threads = threads;
                        options.oneLevel = oneLevel;
                        const SolveResult result = solveResting(*input, options);
                        if (result.status != SolveResult::Status::Solved)
                            throw std::runtime_error("a benchmark failed: " + result.reason.english());
                    });
                };
                return std::vector{solve(false), solve(true)};
            }};
}

/// The share of the time of a solve that reading the factor twice takes.
Benchmark floorFraction(std::string name, int vertices)
{
    return {std::move(name), {"two reads of the factor"}, [vertices] {
                const auto rig = bentRig(vertices);
                const auto system = factored(PositionSystem(rig->mesh()), rig->pool());
                const std::function<void()> read = readOf(system->bytes(), rig->pool());
                return std::vector{ourSolves(system, rig), repeated([rig, read] {
                                       read();
                                       read();
                                   })};
            }};
}

Benchmark growth(std::string name, int vertices, const std::string& to, int moreVertices)
{
    return {std::move(name), {"iteration at " + to}, [vertices, moreVertices] {
                return std::vector{iterations(bentRig(vertices)), iterations(bentRig(moreVertices))};
            }};
}

} // namespace

std::vector<Benchmark> benchmarks(Extent extent)
{
    const bool smoke = extent == Extent::Smoke;
    const int part = smoke ? 40 : 1;
    const auto scaled = [part](int vertices) { return vertices / part; };
    const int n11k = scaled(size11k), n45k = scaled(size45k), n180k = scaled(size180k);
    const int scanned = scaled(8026), scanPoints = 105'126;
    std::vector<Benchmark> all = {
        iteration("iteration_11k", n11k),
        iteration("iteration_45k", n45k),
        convergence("converge_bend_11k", n11k),
        solve("solve_11k", n11k),
        solve("solve_45k", n45k),
        table("table1_basic", 15, [=] { return seat(n11k); }),
        table("table1_cushion", 13, [=] { return cushionedSeat(n11k); }),
        table("table1_g1", 11, [=] { return cushionedSeat(scaled(11331), Continuity::G1); }),
        table("table1_fit", 10, [=] { return scannedSeat(scanned, scanPoints); }),
        setup("setup_11k", n11k),
        drag("drag_11k", n11k),
        release("release_11k", n11k, PatternDrag::Until::NewTriangles),
        release("rest_11k", n11k, PatternDrag::Until::Rest),
        drag("drag_45k", n45k),
        drag("drag_180k", n180k),
        release("release_45k", n45k, PatternDrag::Until::NewTriangles),
        release("release_180k", n180k, PatternDrag::Until::NewTriangles),
        release("rest_45k", n45k, PatternDrag::Until::Rest),
        release("rest_180k", n180k, PatternDrag::Until::Rest),
        cold("cold_armchair_12", "armchair/armchair", smoke ? 60 : 12),
        cold("cold_car_seat", "car-seat/car-seat", smoke ? 60 : 0),
        cold("cold_car_seat_cushioned", "car-seat-cushioned/car-seat-cushioned", smoke ? 60 : 0),
        floorFraction("floor_fraction_45k", n45k),
        growth("growth_11k_45k", n11k, "45k", n45k),
        growth("growth_45k_180k", n45k, "180k", n180k),
        iterationAlone("iteration_3k", scaled(size3k)),
        iterationAlone("iteration_180k", n180k),
    };
    if (extent == Extent::Full) {
        all.push_back(cold("cold_armchair_6", "armchair/armchair", 6));
        all.push_back(cold("cold_armchair_4", "armchair/armchair", 4));
        all.push_back(iterationAlone("iteration_700k", size700k));
    }
    return all;
}

std::vector<Row> run(const Benchmark& benchmark, Extent extent, const std::stop_token& stop)
{
    const double seconds = extent == Extent::Full ? 6 : extent == Extent::Quick ? 1 : 0;
    if (stop.stop_requested())
        return {};
    const std::vector<Lap> laps = benchmark.prepare();
    const std::vector<double> times = race(laps, seconds, stop);
    std::vector<Row> rows;
    if (times.empty())
        return rows;
    for (std::size_t k = 0; k < benchmark.peers.size(); ++k)
        rows.push_back({benchmark.name, times[0], benchmark.peers[k], times[k + 1], benchmark.listed});
    if (const auto& published = benchmark.published)
        rows.push_back({benchmark.name, times[0], published->peer, published->time, benchmark.listed});
    if (rows.empty())
        rows.push_back({benchmark.name, times[0], std::nullopt, 0, benchmark.listed});
    return rows;
}

} // namespace bolster::bench
