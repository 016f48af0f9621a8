// What fits, derivatives and sweeps reach on real covers, as Markdown tables.
#include "CauseFinder.h"
#include "CoverMove.h"
#include "CoverTeam.h"
#include "DesignFile.h"
#include "FitChange.h"
#include "Flatten.h"
#include "FormPattern.h"
#include "MakeGhosts.h"
#include "PatternFit.h"
#include "PreparedSheet.h"
#include "Relaxation.h"
#include "Reliefs.h"
#include "RestingSolve.h"
#include "SheetFollow.h"
#include "SurfacePublisher.h"
#include "Sweep.h"
#include "TestPaths.h"
#include "TriangleTree.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <numbers>
#include <optional>
#include <random>
#include <string_view>
#include <thread>

namespace bolster::test {
namespace {

struct Real {
    const char* name;
    SolveInput input;
};

struct Amount {
    int seeds = 3;
    int samples = 1000;
    int numbers = 24;
    double limit = 2;           ///< of strain, %
    std::string_view free = {}; ///< what may change besides outlines, where strain is the goal

    bool frees(std::string_view what) const { return free.find(what) != std::string_view::npos; }
};

Real realAt(const char* name, const std::string& path)
{
    const OpenedDesign opened = openDesign(QString::fromStdString(path));
    if (!opened.readable) {
        std::cerr << path << " cannot be read\n";
        std::exit(EXIT_FAILURE);
    }
    return {name, {opened.design, opened.files}};
}

class Stopwatch {
public:
    double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_from).count();
    }

private:
    std::chrono::steady_clock::time_point m_from = std::chrono::steady_clock::now();
};

SurfaceMeshPtr restingCover(const SolveInput& input, double tolerance = SolveOptions{}.tolerance)
{
    const SolveResult result = solveResting(input, {.tolerance = tolerance});
    if (!result.surface) {
        std::cerr << result.reason.english() << "\n";
        std::exit(EXIT_FAILURE);
    }
    return result.surface;
}

/// A number from 0 to 1 that is the same on every machine.
double share(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11U) * 0x1.0p-53;
}

/// Its control points along smooth waves around each outline, three in each direction, the farthest by 8 mm.
Design bent(const Design& design, std::uint64_t seed)
{
    constexpr double farthest = 8; // mm
    std::mt19937_64 random(seed);
    std::vector<Freedom> freedoms;
    std::vector<double> values;
    double most = 0;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        const int count = patch.outline.pointCount();
        std::array<std::array<double, 6>, 2> waves{};
        for (auto& axis : waves)
            for (double& number : axis)
                number = share(random);
        for (int k = 0; k < count; ++k) {
            Vec2 move = Vec2::Zero();
            for (int axis = 0; axis < 2; ++axis)
                for (std::size_t h = 0; h < 3; ++h)
                    move[axis] += (2 * waves[axis][2 * h] - 1) *
                                  std::sin(2 * std::numbers::pi *
                                           (static_cast<double>(h + 1) * k / count + waves[axis][2 * h + 1]));
            for (int axis = 0; axis < 2; ++axis) {
                freedoms.push_back({.kind = Freedom::Kind::OutlinePoint,
                                    .element = id,
                                    .index = k,
                                    .direction = Vec2::Unit(axis)});
                values.push_back(move[axis]);
            }
            most = std::max(most, move.norm());
        }
    });
    const Eigen::Map<const Eigen::VectorXd> moves(values.data(), std::ssize(values));
    return withFreedoms(design, freedoms, moves * (farthest / most));
}

/// Points of a cover as a scanner finds them: 1 mm of noise, three holes of 100 mm.
PointCloud scanned(const SurfaceMesh& surface, std::uint64_t seed)
{
    constexpr double areaOfPoint = 30, noise = 1, holeRadius = 50; // mm^2, mm, mm
    std::mt19937_64 random(seed);
    const auto gaussian = [&] { // Box and Muller: std::normal_distribution differs between libraries
        return noise * std::sqrt(-2 * std::log(1 - share(random))) * std::cos(2 * std::numbers::pi * share(random));
    };
    std::array<Vec3, 3> holes;
    for (Vec3& hole : holes)
        hole = surface.positions[random() % surface.positions.size()];
    PointCloud cloud;
    double owed = 0;
    for (const auto& t : surface.topology->triangles) {
        const Vec3 a = surface.positions[t[0]], u = surface.positions[t[1]] - a, v = surface.positions[t[2]] - a;
        for (owed += 0.5 * u.cross(v).norm() / areaOfPoint; owed >= 1; --owed) {
            const double root = std::sqrt(share(random)), across = share(random);
            const Vec3 at = a + root * (1 - across) * u + root * across * v;
            const Vec3 off(gaussian(), gaussian(), gaussian());
            if (std::ranges::none_of(holes, [&](const Vec3& hole) { return (hole - at).norm() < holeRadius; }))
                cloud.points.emplace_back(at + off);
        }
    }
    return cloud;
}

struct Distance {
    double rms = 0, p95 = 0;
};

Distance summary(std::vector<double> sizes)
{
    double squares = 0;
    for (const double size : sizes)
        squares += size * size;
    std::ranges::sort(sizes);
    return {std::sqrt(squares / static_cast<double>(sizes.size())),
            sizes[static_cast<std::size_t>(0.95 * static_cast<double>(sizes.size() - 1))]};
}

/// Of the vertices of a cover from the triangles of another one.
Distance between(const SurfaceMesh& cover, const SurfaceMesh& right)
{
    std::vector<TriangleTree::Triangle> triangles;
    for (const auto& t : right.topology->triangles)
        triangles.push_back({right.positions[t[0]], right.positions[t[1]], right.positions[t[2]]});
    const TriangleTree tree(triangles);
    std::vector<double> sizes;
    for (const Vec3& place : cover.positions)
        sizes.push_back(tree.distance(place, 1000));
    return summary(std::move(sizes));
}

void printFits(const std::vector<Real>& covers, const Amount& amount)
{
    std::printf("### A bent pattern comes back\n\n"
                "| cover | seed | numbers | cover before, rms (P95) mm | after, rms (P95) mm | seams' sides mm | "
                "points moved mm | time s |\n|---|---|---|---|---|---|---|---|\n");
    for (const Real& real : covers) {
        const SurfaceMeshPtr right = restingCover(real.input);
        for (int seed = 1; seed <= amount.seeds; ++seed) {
            const SolveInput wrong{bent(real.input.design, static_cast<std::uint64_t>(seed)), real.input.files};
            FitOrder order;
            order.goals.target = targetOf(Scan{}, scanned(*right, static_cast<std::uint64_t>(seed)));
            order.freedoms = outlineFreedoms(wrong.design);
            const Stopwatch watch;
            const FitResult result = fitPattern(wrong, order);
            const double time = watch.seconds();
            const Distance before = between(*restingCover(wrong), *right);
            const Distance after = between(*restingCover({result.design, wrong.files}), *right);
            std::printf("| %s | %d | %zu | %.2f (%.2f) | %.2f (%.2f) | %.2f | %.1f | %.0f |\n", real.name, seed,
                        order.freedoms.size(), before.rms, before.p95, after.rms, after.p95, result.after.sewnMost,
                        largestChange(order.freedoms, result.values), time);
            std::fflush(stdout);
        }
    }
}

/// Of the right pattern, and of the same bent ones as above.
void printStrains(const std::vector<Real>& covers, const Amount& amount)
{
    std::printf(
        "\n### Strain below a limit, without a scan\n\n"
        "| cover | seed (0: as it is) | limit | area over it before | after | cover changed, rms mm | seams' "
        "sides mm | points moved mm | time s |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const Real& real : covers)
        for (int seed = 0; seed <= amount.seeds; ++seed) {
            const SolveInput wrong{seed > 0 ? bent(real.input.design, static_cast<std::uint64_t>(seed))
                                            : real.input.design,
                                   real.input.files};
            FitOrder order;
            order.goals.strain = true;
            order.goals.keepShape = FitGoals::lightly;
            order.goals.limit = amount.limit;
            order.freedoms = outlineFreedoms(wrong.design);
            if (amount.frees("fixations"))
                std::ranges::move(fixationFreedoms(wrong.design, wrong.files), std::back_inserter(order.freedoms));
            if (amount.frees("seams"))
                std::ranges::move(seamEndFreedoms(wrong.design), std::back_inserter(order.freedoms));
            order.locks.ease = !amount.frees("ease");
            const Stopwatch watch;
            const FitResult result = fitPattern(wrong, order);
            std::printf("| %s | %d | %.1f %% | %.1f %% | %.1f %% | %.2f | %.2f | %.1f | %.0f |\n", real.name, seed,
                        amount.limit, 100 * result.before.overLimit, 100 * result.after.overLimit,
                        result.after.shapeRms, result.after.sewnMost, largestChange(order.freedoms, result.values),
                        watch.seconds());
            std::fflush(stdout);
        }
}

std::vector<const SweepSample*> restingOf(const std::vector<SweepSample>& samples)
{
    std::vector<const SweepSample*> resting;
    for (const SweepSample& sample : samples)
        if (!sample.outside.empty())
            resting.push_back(&sample);
    return resting;
}

void printSweeps(const std::vector<Real>& covers, const Amount& amount)
{
    std::printf(
        "\n### Tolerances, as if covers were linear and solved\n\n"
        "Pieces are cut 1 mm larger or smaller, seams sewn 1 mm farther in or out, fixations 1 mm elsewhere. "
        "P95 of each vertex, over the cover.\n\n"
        "| cover | tolerances | vertices | linear, rms (most) mm | time s | corrected by 64 "
        "pieces, rms (most) mm | time s | samples solved (at rest) | solved, rms (most) mm | linear (corrected) "
        "differ from them by, rms mm | time s |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Real& real : covers) {
        Tolerances tolerances;
        for (const auto& some : {cutTolerances(real.input.design, 1), seamTolerances(real.input.design, 1),
                                 fixationTolerances(real.input.design, 1)})
            tolerances.all.insert(tolerances.all.end(), some.begin(), some.end());
        Sweep sweep(real.input, tolerances, 0);
        const Stopwatch linearWatch;
        const Eigen::MatrixXf columns = sweep.linear();
        constexpr int drawn = 10'000, few = 64;
        const LinearP95 reckoned = linearP95(columns, tolerances, drawn);
        const std::vector<float>& linear = reckoned.map;
        const double linearTime = linearWatch.seconds();
        // Other pieces than those that it is compared with.
        const std::vector<SweepSample> others = sweep.solve(static_cast<std::uint64_t>(amount.samples), few);
        const std::vector<float> corrected = correctedP95(reckoned, columns, tolerances, restingOf(others)).map;
        const double correctedTime = linearWatch.seconds();
        const Stopwatch watch;
        const std::vector<SweepSample> samples = sweep.solve(0, amount.samples);
        const std::vector<const SweepSample*> resting = restingOf(samples);
        const std::vector<float> solved = solvedP95(resting);
        const auto rms = [](const std::vector<float>& map) { return summary({map.begin(), map.end()}).rms; };
        const auto most = [](const std::vector<float>& map) { return *std::ranges::max_element(map); };
        const auto off = [&](std::vector<float> map) {
            std::ranges::transform(map, solved, map.begin(), std::minus());
            return rms(map);
        };
        std::printf("| %s | %zu | %zu | %.2f (%.2f) | %.0f | %.2f (%.2f) | %.0f | %zu (%zu) | %.2f (%.2f) | %.2f "
                    "(%.2f) | %.0f |\n",
                    real.name, tolerances.all.size(), linear.size(), rms(linear), most(linear), linearTime,
                    rms(corrected), most(corrected), correctedTime, samples.size(), resting.size(), rms(solved),
                    most(solved), off(linear), off(corrected), watch.seconds());
        std::fflush(stdout);
    }
}

/// So many of them at most, spread evenly.
std::vector<Freedom> someOf(const std::vector<Freedom>& all, int most)
{
    const std::size_t wanted = std::min(all.size(), static_cast<std::size_t>(most));
    std::vector<Freedom> some;
    for (std::size_t k = 0; k < wanted; ++k)
        some.push_back(all[k * all.size() / wanted]);
    return some;
}

/// How far each vertex lies beside another cover, along its normal, mm.
Eigen::VectorXd heightsOver(const SurfaceMesh& before, const SurfaceMesh& after)
{
    const CoverMove move = moveBetween(before, after);
    Eigen::VectorXd heights = Eigen::VectorXd::Zero(std::ssize(after.positions));
    for (std::size_t v = 0; move.from && v < after.positions.size(); ++v)
        heights[static_cast<Eigen::Index>(v)] =
            after.normals[v].cast<double>().dot(after.positions[v] - move.from->positions[v]);
    return heights;
}

/// Of covers that are compared: single points move a cover by some hundredths of a millimetre, and with the usual
/// tolerance it may lie that much beside its rest.
constexpr double closely = 1e-8; // relative to D

/// The cover of a changed design from its usual start, on the triangles of the design before, bent: null where they
/// cannot stay.
SurfaceMeshPtr restingOnBent(const SolveInput& before, const SolveInput& changed)
{
    TriangulationCache triangles;
    WorkerPool pool(0);
    std::optional<PreparedSheet> sheet = prepareSheet(before, triangles, pool);
    std::optional<PatternWarp> warp;
    Problems problems;
    if (!sheet || !followDesign(*sheet, warp, changed, planSolve(before, changed), pool, problems))
        return nullptr;
    GhostCache ghosts;
    Relaxation relaxation(sheet->mesh, pool, closely,
                          makeGhosts({sheet->design, sheet->files}, sheet->mesh, ghosts, problems, pool));
    relaxation.startCanonically();
    while (relaxation.phase() == Relaxation::Phase::Running)
        relaxation.iterate();
    return makeSurface(sheet->mesh, relaxation.state(), 0);
}

/// Along the normals of `after`, on the same triangles, mm rms.
double apart(const SurfaceMesh& before, const SurfaceMesh& after)
{
    double squares = 0;
    for (std::size_t v = 0; v < after.positions.size(); ++v)
        squares += std::pow(after.normals[v].cast<double>().dot(after.positions[v] - before.positions[v]), 2);
    return std::sqrt(squares / static_cast<double>(after.positions.size()));
}

double medianOf(std::vector<double> values)
{
    if (values.empty())
        return 0;
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Teams {
    CoverTeam usual, close; ///< with the usual tolerance, as it takes its time; and with the other
};

void printDerivativesOf(const Real& real, const char* kind, const std::vector<Freedom>& freedoms, Teams& teams,
                        const SurfaceMesh& home)
{
    const CoverMeasure places = [](const WarmCover& cover, const Design&) { return placesOf(cover); };
    const Stopwatch watch;
    differentiate(teams.usual, real.input.design, freedoms, places, false);
    const double time = watch.seconds() / static_cast<double>(freedoms.size());
    const Derivatives found = differentiate(teams.close, real.input.design, freedoms, places, false);
    std::vector<double> moved, wrong, share, sameShare;
    double fullTime = 0;
    for (std::size_t k = 0; k < freedoms.size(); ++k) {
        if (!found.known[k])
            continue;
        const double step = freedoms[k].step;
        const SolveInput changed{
            withFreedoms(real.input.design, std::span(&freedoms[k], 1), Eigen::VectorXd::Constant(1, step)),
            real.input.files};
        const Stopwatch fullWatch;
        restingCover(changed);
        fullTime += fullWatch.seconds();
        const SurfaceMeshPtr full = restingCover(changed, closely);
        SurfaceMesh predicted = home;
        for (std::size_t v = 0; v < home.positions.size(); ++v)
            predicted.positions[v] +=
                step * found.columns.col(static_cast<Eigen::Index>(k))
                           .segment<3>(3 * static_cast<Eigen::Index>(home.topology->unknown[v]));
        const double size = std::sqrt(static_cast<double>(full->positions.size()));
        moved.push_back(heightsOver(home, *full).norm() / size);
        wrong.push_back(heightsOver(predicted, *full).norm() / size);
        share.push_back(wrong.back() / moved.back());
        if (const SurfaceMeshPtr bent = restingOnBent(real.input, changed))
            sameShare.push_back(apart(predicted, *bent) / apart(home, *bent));
    }
    if (moved.empty())
        return;
    const double solves = static_cast<double>(moved.size());
    std::printf("| %s | %s | %zu (%zu) | %.3f | %.3f (%.1f %%) | %.1f %% (%.1f %%) | %.2f | %.2f |\n", real.name,
                kind, freedoms.size(), moved.size(), medianOf(moved), medianOf(wrong), 100 * medianOf(share),
                100 * medianOf(sameShare), sameShare.empty() ? 0 : 100 * *std::ranges::max_element(sameShare), time,
                fullTime / solves);
    std::fflush(stdout);
}

void printDerivatives(const std::vector<Real>& covers, const Amount& amount)
{
    std::printf(
        "\n### Derivatives against full solves\n\n"
        "What a difference of covers found from the one at rest says of a step (1 mm; 0.05 of pressure) against "
        "the cover of "
        "the changed design, solved from its usual start: on its own triangles, which are others where outlines "
        "have moved "
        "and make a difference of their own, and on the same triangles, bent. Medians.\n\n"
        "| cover | numbers | how many (known) | the cover moves by, rms mm | own triangles: wrong by, rms mm (of "
        "the move) "
        "| the same triangles: wrong by, of the move (at worst) | time of a derivative s | of a full solve s "
        "|\n|---|---|---|---|---|---|---|---|\n");
    for (const Real& real : covers) {
        Teams teams{CoverTeam(real.input, {}, 0), CoverTeam(real.input, {.tolerance = closely}, 0)};
        const SurfaceMesh home = *teams.close.first().surface();
        const Design& design = real.input.design;
        std::vector<Freedom> cuts;
        for (const Tolerance& tolerance : cutTolerances(design, 1))
            cuts.insert(cuts.end(), tolerance.freedoms.begin(), tolerance.freedoms.end());
        for (const auto& [kind, all] :
             {std::pair("points of outlines", outlineFreedoms(design)), std::pair("whole outlines", cuts),
              std::pair("fixations", fixationFreedoms(design)), std::pair("pressure", pressureFreedoms(design))})
            printDerivativesOf(real, kind, someOf(all, amount.numbers / 3), teams, home);
    }
}

/// On a seat that rises into a back and to both sides, u to the right and v to the back, from -1 to 1; mm.
Vec3 onBucket(double u, double v)
{
    return {260 * u, 280 * v, 160 * std::pow(std::max(0.0, v), 2) + 90 * u * u * u * u};
}

/// A bucket of about as many vertices.
TriangleMesh bucket(int vertices)
{
    const int side = static_cast<int>(std::sqrt(vertices)) - 1;
    TriangleMesh mesh;
    for (int row = 0; row <= side; ++row)
        for (int column = 0; column <= side; ++column) {
            const double u = 2.0 * column / side - 1, v = 2.0 * row / side - 1;
            mesh.points.push_back(onBucket(u, v));
        }
    const auto at = [&](int row, int column) { return static_cast<std::uint32_t>(row * (side + 1) + column); };
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            mesh.triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
            mesh.triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
        }
    mesh.parts.push_back({"Seat", 0, static_cast<std::uint32_t>(mesh.triangles.size())});
    return mesh;
}

FormLine lineAcross(const char* name, double share, bool lengthways)
{
    FormLine line{name, {}, false};
    for (int k = 0; k <= 40; ++k) {
        const double u = 2.0 * k / 40 - 1, across = share + 0.05 * (1 - u * u);
        line.points.push_back(lengthways ? onBucket(across, u) : onBucket(u, across));
    }
    return line;
}

/// What the window does while a seam line is dragged, and when it is let go.
void printDraggedLines()
{
    std::printf(
        "\n### A seam line is dragged on a form\n\n"
        "A bucket seat, four lines drawn on it, one of which goes in 20 steps. Each step cuts the form anew, "
        "lays all pieces flat and makes the pattern.\n\n"
        "| vertices | pieces | a step, median s (cutting, laying flat, pattern) | at most s "
        "(of the first two, which cut the lines that stay) | when it is let go s |\n"
        "|---|---|---|---|---|\n");
    for (const int vertices : {2500, 10000, 22500}) {
        const TriangleMesh mesh = bucket(vertices);
        const auto draft = newFormDraft();
        std::vector<std::array<double, 4>> times; // the sum first
        std::size_t pieces = 0;
        double whole = 0;
        for (int step = 0; step <= 20; ++step) {
            FormCuts cuts;
            cuts.lines = {lineAcross("left", -0.5, true), lineAcross("right", 0.45, true),
                          lineAcross("back", 0.1, false), lineAcross("moves", -0.6 + 0.02 * step, false)};
            const Stopwatch watch;
            const Form form = cutForm(mesh, cuts, {}, step < 20 ? draft.get() : nullptr);
            const double cut = watch.seconds();
            const std::vector<FlatPiece> flat = flatten(form, step < 20 ? draftFlattening : FlattenOrder{});
            const double laid = watch.seconds();
            const FormPattern pattern = formPattern(form, flat, {});
            if (step < 20)
                times.push_back({watch.seconds(), cut, laid - cut, watch.seconds() - laid});
            else
                whole = watch.seconds();
            pieces = pattern.patches.size();
        }
        const double first = std::max(times[0][0], times[1][0]);
        times.erase(times.begin(), times.begin() + 2);
        std::ranges::sort(times);
        const std::array<double, 4> median = times[times.size() / 2];
        std::printf("| %zu | %zu | %.3f (%.3f, %.3f, %.3f) | %.3f (%.3f) | %.2f |\n", mesh.points.size(), pieces,
                    median[0], median[1], median[2], median[3], times.back()[0], first, whole);
        std::fflush(stdout);
    }
}

struct Stopped {
    double whole = 0;           ///< s, undisturbed
    std::vector<double> delays; ///< s, from the wish to the end
};

/// Stopped after several shares of its time.
Stopped stopAtShares(const std::function<void(const std::stop_token&)>& work)
{
    Stopped stopped;
    const Stopwatch watch;
    work({});
    stopped.whole = watch.seconds();
    for (const double share : {0.02, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95}) {
        std::atomic<bool> ended = false;
        std::jthread thread([&](const std::stop_token& stop) {
            work(stop);
            ended = true;
        });
        std::this_thread::sleep_for(std::chrono::duration<double>(share * stopped.whole));
        const bool early = !ended;
        const Stopwatch delay;
        thread.request_stop();
        thread.join();
        if (early)
            stopped.delays.push_back(delay.seconds());
    }
    return stopped;
}

void printCancelling(const std::vector<Real>& covers)
{
    std::printf("\n### Stopping\n\n| work | cover | the whole s | stopped so often | it ends after, median s | "
                "at most s |\n|---|---|---|---|---|---|\n");
    const auto print = [](const char* work, const char* cover, const Stopped& stopped) {
        std::vector<double> delays = stopped.delays;
        std::ranges::sort(delays);
        if (!delays.empty())
            std::printf("| %s | %s | %.1f | %zu | %.3f | %.3f |\n", work, cover, stopped.whole, delays.size(),
                        delays[delays.size() / 2], delays.back());
        std::fflush(stdout);
    };
    const TriangleMesh form = bucket(160'000);
    print("laying a form flat", "bucket, 160,000 vertices", stopAtShares([&](const std::stop_token& stop) {
              FormCuts cuts;
              cuts.lines = {lineAcross("left", -0.5, true), lineAcross("back", 0.1, false)};
              flatten(cutForm(form, cuts, stop), {}, stop);
          }));
    for (const Real& real : covers) {
        const SurfaceMeshPtr right = restingCover(real.input);
        const SolveInput wrong{bent(real.input.design, 1), real.input.files};
        FitOrder order;
        order.goals.target = targetOf(Scan{}, scanned(*right, 1));
        order.freedoms = outlineFreedoms(wrong.design);
        print("fit", real.name,
              stopAtShares([&](const std::stop_token& stop) { fitPattern(wrong, order, {}, stop); }));
        print("reliefs", real.name, stopAtShares([&](const std::stop_token& stop) {
                  ReliefOrder relief;
                  relief.limit = 2;
                  proposeReliefs(wrong, relief, {}, stop);
              }));
        print("causes", real.name, stopAtShares([&](const std::stop_token& stop) {
                  CauseFinder finder(real.input, {}, {}, stop);
                  if (!stop.stop_requested())
                      finder.explain(order.goals.target, {}, {}, stop);
              }));
        print("tolerances", real.name, stopAtShares([&](const std::stop_token& stop) {
                  Tolerances tolerances;
                  tolerances.all = cutTolerances(real.input.design, 1);
                  Sweep sweep(real.input, tolerances, 0, stop);
                  if (!stop.stop_requested())
                      linearP95(sweep.linear({}, stop), tolerances, 10000, stop);
                  if (!stop.stop_requested())
                      sweep.solve(0, 40, stop);
              }));
    }
}

int run(int count, char** words)
{
    Amount amount;
    std::string which = "abcdef";
    for (int k = 1; k < count; ++k) {
        const std::string_view word = words[k];
        if (word == "--quick")
            amount = {1, 50, 9};
        else if (word == "--samples" && k + 1 < count)
            amount.samples = std::max(1, std::atoi(words[++k]));
        else if (word == "--seeds" && k + 1 < count)
            amount.seeds = std::max(1, std::atoi(words[++k]));
        else if (word == "--limit" && k + 1 < count)
            amount.limit = std::atof(words[++k]);
        else if (word == "--free" && k + 1 < count)
            amount.free = words[++k];
        else if (word == "--only" && k + 1 < count)
            which = words[++k];
        else {
            std::cout
                << "Usage: bolster_inverse_figures [--quick] [--samples N] [--seeds N] [--limit PERCENT] [--only "
                   "LETTERS] [--free fixations,seams,ease]\n\n"
                   "Tables: a a bent pattern comes back, b strain below a limit, c tolerances, d derivatives, "
                   "e a dragged seam line, f stopping.\n";
            return word == "--help" ? EXIT_SUCCESS : EXIT_FAILURE;
        }
    }
    const std::vector<Real> covers{realAt("armchair body", dataFolder() + "/truth/armchair-body.json"),
                                   realAt("car seat", dataFolder() + "/designs/car-seat-tied.json")};
    std::vector<Real> withPillow = covers;
    withPillow.push_back(realAt("pillow", samplesFolder() + "/pillow/pillow.json"));
    const auto wants = [&](char letter) { return which.find(letter) != std::string::npos; };
    if (wants('a'))
        printFits(covers, amount);
    if (wants('b'))
        printStrains(covers, amount);
    if (wants('c'))
        printSweeps(withPillow, amount);
    if (wants('d'))
        printDerivatives(covers, amount);
    if (wants('e'))
        printDraggedLines();
    if (wants('f'))
        printCancelling(covers);
    return EXIT_SUCCESS;
}

} // namespace
} // namespace bolster::test

int main(int count, char** words)
{
    return bolster::test::run(count, words);
}
