#include "Listener.h"
#include "TestDesigns.h"
#include "TestMeshes.h"

#include "CoverMove.h"
#include "CurveEdits.h"
#include "PatchEdits.h"
#include "RestingCache.h"
#include "SolvePlan.h"
#include "SolverThread.h"
#include "StateTransfer.h"

#include "PreparedSheet.h"
#include "Relaxation.h"

#include <gtest/gtest.h>

#include <future>
#include <random>

namespace bolster::test {
namespace {

using State = SolverStatus::State;

Design withOutlineMoved(const Design& design, const Vec2& delta)
{
    const int points[] = {0};
    return design.with(edits::movePatchPoints(design, firstOf<Patch>(design), points, delta));
}

template <class T, class Change>
Design changed(const Design& design, ElementId id, Change change)
{
    T value = *design.find<T>(id);
    change(value);
    return design.with({{}, {{id, design.element(id), makeElement(value)}}});
}

TEST(SolvePlan, AsksForAsLittleAsPossible)
{
    const Design design = box(200, 60, 20, 10, 0.3);
    ElementId fabric{};
    design.each<Fabric>([&](ElementId id, const Fabric&) { fabric = id; });
    const ElementId patch = firstOf<Patch>(design);
    EXPECT_EQ(planSolve(design, design), SolvePlan::Nothing);
    EXPECT_EQ(planSolve(design, changed<Fabric>(design, fabric, [](Fabric& f) { f.color = "#000000"; })),
              SolvePlan::Nothing);
    EXPECT_EQ(planSolve(design, changed<Patch>(design, patch, [](Patch& p) { p.rotation = 30; })),
              SolvePlan::Nothing);
    EXPECT_EQ(planSolve(design, changed<Patch>(design, patch, [](Patch& p) { p.pressure = 1; })),
              SolvePlan::Retarget);
    EXPECT_EQ(planSolve(design, changed<Fabric>(design, fabric, [](Fabric& f) { f.poisson = 0; })),
              SolvePlan::Retarget);
    EXPECT_EQ(planSolve(design, withCurveMoved(design, Vec3(0, 0, 5))), SolvePlan::Retarget);
    EXPECT_EQ(planSolve(design, changed<Fabric>(design, fabric, [](Fabric& f) { f.bendingLength = 3; })),
              SolvePlan::Refactor);
    const Design dragged = withOutlineMoved(design, Vec2(3, 0));
    EXPECT_EQ(planSolve(design, dragged), SolvePlan::Warp);
    EXPECT_EQ(planSolve(design, changed<Patch>(dragged, patch, [](Patch& p) { p.pressure = 1; })), SolvePlan::Warp);
    EXPECT_EQ(planSolve(design, changed<Fabric>(dragged, fabric, [](Fabric& f) { f.stiffness = 2; })),
              SolvePlan::Rebuild);
    EXPECT_EQ(
        planSolve(design, changed<Patch>(design, patch, [](Patch& p) { p.outline = p.outline.withKnot(0.5); })),
        SolvePlan::Rebuild);
    ElementId held{};
    design.each<FixationSeam>([&](ElementId id, const FixationSeam&) { held = id; });
    const auto leaning = [&](const Design& from, const Vec3& normal, double weight) {
        return changed<FixationSeam>(from, held, [&](FixationSeam& f) {
            f.orientation = {Orientation::Kind::Normal, {normal}, weight};
        });
    };
    const Design up = leaning(design, Vec3(0, 0, 1), 1);
    EXPECT_EQ(planSolve(design, up), SolvePlan::Rebuild);
    EXPECT_EQ(planSolve(up, leaning(up, Vec3(0, 1, 1), 1)), SolvePlan::Retarget);
    EXPECT_EQ(planSolve(up, leaning(up, Vec3(0, 0, 1), 2)), SolvePlan::Refactor);
    ElementId seam{};
    design.each<Seam>([&](ElementId id, const Seam&) { seam = id; });
    EXPECT_EQ(planSolve(design, changed<Seam>(design, seam, [](Seam& s) { s.continuity = Continuity::G1; })),
              SolvePlan::Refactor);
    EXPECT_EQ(planSolve(design, design.with({{}, {{seam, design.element(seam), nullptr}}})), SolvePlan::Resew);
}

TEST(SolvePlan, LooksAskForNothing)
{
    const Design design = box(200, 60, 20, 10, 0.3);
    const auto first = [&]<class T>(const T&) {
        ElementId found{};
        design.each<T>([&](ElementId id, const T&) { found = id; });
        return found;
    };
    const ElementId fabric = first(Fabric()), seam = first(Seam()), held = first(FixationSeam());
    SeamTrim trim;
    trim.stitch = SeamTrim::Stitch::Twin;
    trim.pipingRadius = 3;
    const auto withNew = [&](ElementPtr element) {
        return design.with({{}, {{design.nextId(), nullptr, std::move(element)}}});
    };
    for (const Design& other :
         {changed<Fabric>(design, fabric, [](Fabric& f) { f.look = usualLook(FabricLook::Kind::Velvet); }),
          changed<Fabric>(design, fabric, [](Fabric& f) { f.limits.shear = 1; }),
          changed<Seam>(design, seam, [&](Seam& s) { s.trim = trim; }),
          changed<FixationSeam>(design, held, [&](FixationSeam& f) { f.trim = trim; }),
          withNew(makeElement(OutlineTrim{{firstOf<Patch>(design), 0, 1}, trim})),
          withNew(makeElement(Colourway{"Blue", {{firstOf<Patch>(design), fabric}}}))}) {
        EXPECT_FALSE(design == other);
        EXPECT_EQ(planSolve(design, other), SolvePlan::Nothing);
        EXPECT_EQ(planSolve(other, design), SolvePlan::Nothing);
    }
    EXPECT_EQ(
        planSolve(design, changed<Settings>(design, settingsId, [](Settings& s) { s.colourway = ElementId{9}; })),
        SolvePlan::Nothing);
}

TEST(StateTransfer, KeepsTheSurface)
{
    const Design design = tube(400, 200, 14, 8);
    TriangulationCache cache;
    const auto coarse = prepareSheet(design, cache);
    Settings finer;
    finer.edgeLength = 9;
    const Design refined = design.with({{}, {{settingsId, design.element(settingsId), makeElement(finer)}}});
    const auto fine = prepareSheet(refined, cache);
    WorkerPool pool(1);
    Relaxation relaxation(coarse->mesh, pool, 1e-5);
    relaxation.startCanonically();
    while (relaxation.phase() == Relaxation::Phase::Running)
        relaxation.iterate();
    const SheetState carried = transferState(coarse->mesh, relaxation.state(), fine->mesh);
    // A chord of 14 mm in a circle of this radius lies 0.4 mm inside.
    EXPECT_LT(surfaceDistance(fine->mesh, carried, coarse->mesh, relaxation.state()), 1.0);
    for (Eigen::Index v = 0; v < carried.frames.cols(); ++v)
        EXPECT_NEAR(carried.frames.col(v).norm(), 1, 1e-9);
}

TEST(SolverThread, ReachesTheRestingSurface)
{
    const Design design = box(200, 60, 15, 10, 0.3);
    Listener solver;
    solver.request(design, 7);
    const auto output =
        solver.waitFor([](const SolverOutput& o) { return o.status.state == State::Settled && o.status.resting; });
    ASSERT_TRUE(output);
    EXPECT_EQ(output->designRevision, 7u);
    EXPECT_EQ(output->surface->positions, solved(design, 1e-6).surface->positions);
    EXPECT_GT(output->report.vertices, 0);
}

TEST(SolverThread, ComesBackToTheRestingSurfaceAfterADrag)
{
    Design design = hammock();
    Listener solver;
    std::uint64_t revision = 0;
    for (int step = 0; step < 12; ++step) {
        solver.request(withCurveMoved(design, Vec3(0, -step, 0.5 * step)), ++revision, true);
        const auto output =
            solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.surface; });
        ASSERT_TRUE(output);
    }
    design = withCurveMoved(design, Vec3(0, -11, 5.5));
    solver.request(design, ++revision);
    const auto resting =
        solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.status.resting; });
    ASSERT_TRUE(resting);
    EXPECT_EQ(resting->surface->positions, solved(design, 1e-6).surface->positions);
}

TEST(SolverThread, BendsTheTriangulationWhileAnOutlineIsDraggedAndMakesANewOneOnRelease)
{
    const Design design = hammock();
    const auto dragged = [&](double step) { return withOutlineMoved(design, Vec2(-step, -0.5 * step)); };
    Listener solver;
    std::uint64_t revision = 1;
    solver.request(design, revision);
    const auto before = solver.waitFor([](const SolverOutput& o) { return o.status.resting; });
    ASSERT_TRUE(before);
    SurfaceMeshPtr last = before->surface;
    int bent = 0; // not always: a busy machine leaves time to settle between two moves
    for (int step = 1; step <= 12; ++step) {
        solver.request(dragged(step), ++revision, true);
        const auto output =
            solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.surface; });
        ASSERT_TRUE(output);
        bent += output->surface->topology->serial == last->topology->serial ? 1 : 0;
        EXPECT_LT((output->surface->topology->pattern[0] - Vec2(-step, -0.5 * step)).norm(), 1e-9);
        last = output->surface;
    }
    EXPECT_GT(bent, 0);
    solver.request(dragged(12), ++revision);
    const auto resting =
        solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.status.resting; });
    ASSERT_TRUE(resting);
    EXPECT_NE(resting->surface->topology->serial, last->topology->serial);
    EXPECT_EQ(resting->surface->positions, solved(dragged(12), 1e-6).surface->positions);
}

/// While the pointer stands still the surface may be triangulated again; what follows is bent from there.
TEST(SolverThread, DragsOnAfterARest)
{
    const Design design = hammock();
    Listener solver;
    solver.request(design, 1);
    ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.status.resting; }));
    for (std::uint64_t revision = 2; revision < 6; ++revision) {
        const Design dragged = withOutlineMoved(design, Vec2(-4.0 * static_cast<double>(revision), 0));
        solver.request(dragged, revision, true);
        const auto output =
            solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.status.resting; });
        ASSERT_TRUE(output);
        EXPECT_EQ(output->surface->positions, solved(dragged, 1e-6).surface->positions);
    }
}

TEST(SolverThread, EachTakenRequestIsAnsweredWithASurface)
{
    const Design design = tube(400, 200, 20, 8);
    Listener solver;
    std::mt19937 random(5);
    SurfaceMeshPtr last;
    for (std::uint64_t revision = 1; revision <= 40; ++revision) {
        const double amount = std::uniform_real_distribution<double>(-6, 6)(random);
        solver.request(revision % 3 == 0 ? withOutlineMoved(design, Vec2(amount, 0))
                                         : withCurveMoved(design, Vec3(0, 0, amount)),
                       revision, revision % 8 != 0);
        if (revision % 4 != 0)
            continue; // the others may be skipped: latest wins
        const auto output =
            solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.surface; });
        ASSERT_TRUE(output) << revision;
        if (last) {
            EXPECT_GT(output->surface->revision, last->revision);
        }
        last = output->surface;
        for (const Vec3& p : last->positions)
            ASSERT_TRUE(p.allFinite());
    }
}

TEST(SolverThread, LayoutChangesKeepTheSurface)
{
    const Design design = box(200, 60, 20, 10, 0);
    Listener solver;
    solver.request(design, 1);
    const auto before = solver.waitFor([](const SolverOutput& o) { return o.status.resting; });
    ASSERT_TRUE(before);
    solver.request(changed<Patch>(design, firstOf<Patch>(design), [](Patch& p) { p.position = Vec2(50, 50); }), 2);
    const auto after = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 2; });
    ASSERT_TRUE(after);
    EXPECT_EQ(after->surface->revision, before->surface->revision);
}

TEST(SolverThread, ABadPatchIsLeftOutAndComesBackWhereItWas)
{
    const Design good = box(200, 60, 15, 10, 0);
    const ElementId top = firstOf<Patch>(good);
    Listener solver;
    solver.request(good, 1);
    const auto before = solver.waitFor([](const SolverOutput& o) { return o.status.resting; });
    ASSERT_TRUE(before);
    const Design bad = changed<Patch>(good, top, [](Patch& p) {
        p.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {0, 200}, {200, 200}});
    });
    solver.request(bad, 2);
    const auto during = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 2; });
    ASSERT_TRUE(during);
    EXPECT_TRUE(hasErrors(during->status.problems));
    EXPECT_EQ(during->surface->topology->patches.size(), before->surface->topology->patches.size() - 1);
    solver.request(good, 3);
    const auto after =
        solver.waitFor([](const SolverOutput& o) { return o.designRevision == 3 && o.status.resting; });
    ASSERT_TRUE(after);
    EXPECT_EQ(after->surface->positions, before->surface->positions);
}

TEST(SolverThread, AnEmptyDesignClearsTheSurface)
{
    Listener solver;
    solver.request(box(200, 60, 20, 10, 0), 1);
    ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.surface != nullptr; }));
    solver.request(Design(), 2);
    const auto output = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 2; });
    ASSERT_TRUE(output);
    EXPECT_EQ(output->status.state, State::Idle);
    EXPECT_TRUE(output->surface->positions.empty());
}

/// Where nothing was to solve a first design is being solved, and meanwhile a patch is moved in the layout.
TEST(SolverThread, AFirstDesignIsSolvedThoughItsLayoutChangesMeanwhile)
{
    const Design design = box(300, 100, 5, 10, 0.3); // takes long
    const Design moved =
        changed<Patch>(design, firstOf<Patch>(design), [](Patch& p) { p.position = Vec2(50, 50); });
    for (const bool undone : {false, true}) {
        Listener solver;
        solver.request(Design(), 1);
        ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.status.state == State::Idle; }));
        solver.request(design, 2);
        ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.status.state == State::Moving; }));
        solver.request(moved, 3, true);
        const auto during = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 3; });
        ASSERT_TRUE(during);
        EXPECT_NE(during->status.state, State::Idle);
        solver.request(undone ? design : moved, 4);
        const auto after =
            solver.waitFor([](const SolverOutput& o) { return o.designRevision == 4 && o.status.resting; });
        ASSERT_TRUE(after);
        EXPECT_EQ(after->status.state, State::Settled);
        EXPECT_EQ(after->surface->positions, solved(design, 1e-6).surface->positions);
    }
}

/// The trapezoid whose cloth lies in folds, with triangles large enough for a test.
Design coarseFolds()
{
    Settings coarse;
    coarse.edgeLength = 14;
    const Design folded = sample("trapezoid");
    return folded.with({{}, {{settingsId, folded.element(settingsId), makeElement(coarse)}}});
}

/// Lifts a corner far out and lets it come to rest there: other folds remain after that.
void crumple(Listener& solver, const Design& design, std::uint64_t revision)
{
    solver.request(withCurveMoved(design, Vec3(0, 250, 0)), revision, true);
    ASSERT_TRUE(solver.waitFor(
        [&](const SolverOutput& o) { return o.designRevision == revision && o.status.state == State::Settled; }));
}

TEST(SolverThread, AGestureThatIsCancelledLeavesNothingOfItsFolds)
{
    const Design design = coarseFolds();
    Listener solver;
    solver.request(design, 1);
    const auto before = solver.waitFor([](const SolverOutput& o) { return o.status.resting; });
    ASSERT_TRUE(before);
    crumple(solver, design, 2);
    solver.request(design, 3);
    const auto after = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 3; });
    ASSERT_TRUE(after);
    EXPECT_TRUE(after->status.resting) << "with the first answer";
    EXPECT_EQ(after->surface->positions, before->surface->positions);
    EXPECT_FALSE(after->from) << "at once";
    EXPECT_FALSE(after->status.sprang) << "it was asked for";
}

TEST(SolverThread, AfterAGestureTheCoverIsThatOfTheDesignAndSaysWhetherItSprang)
{
    const Design design = coarseFolds();
    const Design moved = withCurveMoved(design, Vec3(0, 3, 0));
    Listener solver;
    solver.request(design, 1);
    ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.status.resting; }));
    crumple(solver, design, 2);
    solver.request(moved, 3, true);
    const auto live = solver.waitFor(
        [](const SolverOutput& o) { return o.designRevision == 3 && o.status.state == State::Settled; });
    ASSERT_TRUE(live);
    solver.request(moved, 4);
    const auto after =
        solver.waitFor([](const SolverOutput& o) { return o.designRevision == 4 && o.status.resting; });
    ASSERT_TRUE(after);
    EXPECT_EQ(after->surface->positions, solved(moved, 1e-6).surface->positions);
    const CoverMove way = moveBetween(*live->surface, *after->surface);
    EXPECT_EQ(after->status.sprang.has_value(), way.distance > 5) << way.distance;
    EXPECT_EQ(after->from != nullptr, way.distance > 0.5) << "the eye can follow";
}

TEST(SolverThread, AVersionVisitedLatelyIsThereAtOnce)
{
    const Design design = hammock();
    Listener solver;
    solver.request(design, 1);
    const auto before = solver.waitFor([](const SolverOutput& o) { return o.status.resting; });
    ASSERT_TRUE(before);
    solver.request(withOutlineMoved(design, Vec2(-20, -10)), 2);
    ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.designRevision == 2; }));
    solver.request(design, 3);
    bool worked = false;
    const auto after = solver.waitFor([&](const SolverOutput& o) {
        worked = worked || o.status.state != State::Settled;
        return o.designRevision == 3;
    });
    ASSERT_TRUE(after);
    EXPECT_FALSE(worked) << "nothing is solved again";
    EXPECT_EQ(after->surface->positions, before->surface->positions);
    EXPECT_GT(after->surface->revision, before->surface->revision);
    // A drag begins there.
    solver.request(withCurveMoved(design, Vec3(0, 0, 1)), 4, true);
    const auto live = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 4; });
    ASSERT_TRUE(live);
    EXPECT_LT(moveBetween(*before->surface, *live->surface).distance, 5);
}

TEST(RestingCache, KeepsWhatWasUsedLastWithinItsBounds)
{
    const auto kept = [](const Design& design) {
        return RestingSurface{design, solved(design, 1e-3).surface, {}, {}, {}, {}, 0};
    };
    const Design design = box(200, 60, 30, 10, 0);
    RestingCache cache(1);
    for (int step = 0; step < 4; ++step)
        cache.keep(kept(withOutlineMoved(design, Vec2(step, 0))));
    EXPECT_EQ(cache.count(), 2u) << "however large";
    EXPECT_TRUE(cache.find(withOutlineMoved(design, Vec2(3, 0))));
    EXPECT_TRUE(cache.find(withOutlineMoved(design, Vec2(2, 0))));
    EXPECT_FALSE(cache.find(withOutlineMoved(design, Vec2(1, 0))));
    cache.keep(kept(design));
    EXPECT_TRUE(cache.find(withOutlineMoved(design, Vec2(2, 0)))) << "asked for last";
    EXPECT_FALSE(cache.find(withOutlineMoved(design, Vec2(3, 0))));
    cache.keep(kept(design));
    EXPECT_EQ(cache.count(), 2u) << "once each";
}

/// As when two versions are compared: the other window has a thread of its own.
TEST(SolverThread, FindsWhatAnotherOneHasSolvedAndLeavesItThere)
{
    const auto resting = [](const SolverOutput& o) { return o.status.resting; };
    const Design before = hammock();
    const Design after = withCurveMoved(before, Vec3(0, 0, 5));
    Listener first;
    first.request(before, 1);
    const auto solved = first.waitFor(resting);
    ASSERT_TRUE(solved);
    Listener second(first.kept());
    second.startAnew();
    second.request(before, 1);
    const auto found = second.waitFor(resting);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->report.time.total, solved->report.time.total) << "it was not solved once more";
    EXPECT_EQ(found->surface->positions, solved->surface->positions);
    second.request(after, 2);
    ASSERT_TRUE(second.waitFor(resting));
    EXPECT_EQ(first.kept()->count(), 2u) << "each for the other";
    first.startAnew();
    first.request(after, 2);
    ASSERT_TRUE(first.waitFor(resting));
    EXPECT_EQ(first.kept()->count(), 1u) << "another design was opened";
}

TEST(SolverThread, GivesUpWhatIsOutdated)
{
    const Design design = box(300, 100, 20, 10, 0);
    Settings fine;
    fine.edgeLength = 0.8;
    Listener solver;
    solver.request(design, 1);
    const auto before = solver.waitFor([](const SolverOutput& o) { return o.status.resting; });
    ASSERT_TRUE(before);
    solver.request(design.with({{}, {{settingsId, design.element(settingsId), makeElement(fine)}}}), 2);
    ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.status.state == State::Preparing; }));
    solver.request(design, 3);
    const auto after = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 3; });
    ASSERT_TRUE(after);
    EXPECT_EQ(after->status.state, State::Settled);
    EXPECT_EQ(after->surface->revision, before->surface->revision);
}

/// An element that does nothing to the cover comes while that is being prepared: asked for on the solver's own
/// thread, so that it is in time however slow or fast that is.
TEST(SolverThread, WhatDoesNotTouchTheCoverBeginsNothingAnew)
{
    const Design design = box(300, 100, 20, 10, 0);
    Fabric unused;
    unused.name = "Unused";
    const Design after = design.with({{}, {{design.nextId(), nullptr, makeElement(unused)}}});
    bool asked = false;
    bool waiting = true;
    int again = 0;
    std::promise<void> moved; // and with that all of the above is seen here
    std::unique_ptr<SolverThread> solver;
    solver = std::make_unique<SolverThread>([&] {
        const std::optional<SolverOutput> output = solver->take();
        if (!output || !waiting)
            return;
        const bool preparing = output->status.state == State::Preparing;
        const bool triangles = output->status.stage == SolverStatus::Stage::Triangles;
        if (asked) {
            again += preparing && triangles;
            waiting = output->designRevision != 2 || preparing;
            if (!waiting)
                moved.set_value();
        } else if (preparing && !triangles) {
            asked = true;
            solver->request({after}, 2);
        }
    });
    solver->request({design}, 1);
    ASSERT_EQ(moved.get_future().wait_for(std::chrono::minutes(1)), std::future_status::ready);
    EXPECT_EQ(again, 0);
}

TEST(SolverThread, StopsInTheMiddleOfWork)
{
    for (const State middle : {State::Preparing, State::Moving}) {
        const auto kept = std::make_shared<RestingCache>(64 << 20);
        {
            Listener solver(kept);
            solver.request(box(300, 100, 3, 10, 0.3), 1); // takes long
            ASSERT_TRUE(solver.waitFor([=](const SolverOutput& o) {
                return o.status.state == middle || o.status.state == State::Moving;
            }));
        }
        EXPECT_EQ(kept->count(), 0u) << "it was not brought to an end first";
    }
}

/// The hammock with a fancy seam across it and a handle beside that.
struct DrawnOn {
    Design design = hammock();
    ElementId seam{100}, handle{101};

    DrawnOn()
    {
        const ElementId patch = firstOf<Patch>(design);
        FancySeam groove{{"Groove", patch, BSpline2(1, false, {{200, 0}, {200, 200}})}};
        HandleCurve bump{{"Bump", patch, BSpline2(1, false, {{60, 100}, {120, 100}})},
                         BSpline3(1, false, {{60, 105, 30}, {120, 105, 30}})};
        design = design.with({{}, {{seam, nullptr, makeElement(groove)}, {handle, nullptr, makeElement(bump)}}});
    }
};

TEST(SolverThread, ShowsAnotherDepthWithoutSolvingAgain)
{
    const DrawnOn drawn;
    Listener solver;
    solver.request(drawn.design, 1);
    const auto before =
        solver.waitFor([](const SolverOutput& o) { return o.status.state == State::Settled && o.status.resting; });
    ASSERT_TRUE(before);
    const Design deeper = changed<FancySeam>(drawn.design, drawn.seam, [](FancySeam& s) { s.depth = 9; });
    solver.request(deeper, 2);
    const auto after = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 2; });
    ASSERT_TRUE(after);
    EXPECT_EQ(after->status.state, State::Settled) << "with the first answer";
    EXPECT_TRUE(after->status.resting);
    EXPECT_EQ(after->surface->topology, before->surface->topology);
    EXPECT_NEAR(after->report.fancySeams.at(0).value, 9, 1e-9);
    EXPECT_EQ(after->surface->positions, solved(deeper, 1e-6).surface->positions);
    // A depth that is not allowed takes the seam away, with a reason.
    solver.request(changed<FancySeam>(deeper, drawn.seam, [](FancySeam& s) { s.depth = 1e9; }), 3);
    const auto bad = solver.waitFor(
        [](const SolverOutput& o) { return o.designRevision == 3 && o.status.state == State::Settled; });
    ASSERT_TRUE(bad);
    EXPECT_TRUE(hasErrors(bad->status.problems));
    EXPECT_TRUE(std::ranges::none_of(bad->surface->topology->lines,
                                     [&](const auto& line) { return line.element == drawn.seam; }));
}

/// How deep a fancy seam lies under its outer lines halfway along, mm.
double depthInTheMiddle(const SurfaceMesh& surface, ElementId seam)
{
    double depth = 0;
    for (const SurfaceTopology::Line& line : surface.topology->lines) {
        const double height = surface.positions[line.vertices[line.vertices.size() / 2]].z();
        if (line.element == seam && std::abs(line.across) == 1)
            depth += 0.5 * height;
        else if (line.element == seam && line.across == 0)
            depth -= height;
    }
    return depth;
}

TEST(SolverThread, FollowsTheTargetOfAHandle)
{
    const DrawnOn drawn;
    Listener solver;
    solver.request(drawn.design, 1);
    ASSERT_TRUE(solver.waitFor([](const SolverOutput& o) { return o.status.state == State::Settled; }));
    const auto lifted = [&](double z) {
        return changed<HandleCurve>(drawn.design, drawn.handle, [&](HandleCurve& h) {
            h.target = BSpline3(1, false, {{60, 105, z}, {120, 105, z}});
        });
    };
    SurfaceMeshPtr last;
    for (int step = 1; step <= 5; ++step) {
        solver.request(lifted(30 + 2 * step), static_cast<std::uint64_t>(1 + step), true);
        const auto output = solver.waitFor([&](const SolverOutput& o) {
            return o.designRevision == static_cast<std::uint64_t>(1 + step) && o.surface;
        });
        ASSERT_TRUE(output);
        for (const SurfaceTopology::Line& line : output->surface->topology->lines)
            for (const std::uint32_t v :
                 line.element == drawn.handle ? line.vertices : std::vector<std::uint32_t>())
                EXPECT_NEAR(output->surface->positions[v].z(), 30 + 2 * step, 1e-9) << "with every surface";
        const double depth = drawn.design.find<FancySeam>(drawn.seam)->depth;
        EXPECT_NEAR(depthInTheMiddle(*output->surface, drawn.seam), depth, 0.3 * depth) << "with every surface";
    }
    solver.request(lifted(40), 7);
    const auto resting =
        solver.waitFor([](const SolverOutput& o) { return o.designRevision == 7 && o.status.resting; });
    ASSERT_TRUE(resting);
    EXPECT_LT(resting->report.handles.at(0).value, 1e-9);
}

TEST(StateTransfer, KeepsTheSurfaceWhenCurvesAreDrawnInIt)
{
    const Design plain = hammock();
    const DrawnOn drawn;
    const Design grooved = drawn.design.with({{}, {{drawn.handle, nullptr, nullptr}}});
    TriangulationCache cache;
    const auto before = prepareSheet(plain, cache);
    WorkerPool pool(1);
    Relaxation relaxation(before->mesh, pool, 1e-5);
    relaxation.startCanonically();
    while (relaxation.phase() == Relaxation::Phase::Running)
        relaxation.iterate();
    const auto after = prepareSheet(grooved, cache);
    const SheetState carried = transferState(before->mesh, relaxation.state(), after->mesh);
    EXPECT_LT(surfaceDistance(after->mesh, carried, before->mesh, relaxation.state()), 0.5);
}

TEST(SolverThread, FollowsCushioningAndDrawsItsForces)
{
    SolveInput input{box(200, 80, 16, 8, 0)};
    Frame frame;
    frame.file = "frame.obj";
    const ElementId frameId = input.design.nextId();
    input.design = input.design.with({{}, {{frameId, nullptr, makeElement(frame)}}});
    Cushion cushion;
    cushion.frame = frameId;
    cushion.dilation = 40;
    const ElementId id = input.design.nextId();
    input.design = input.design.with({{}, {{id, nullptr, makeElement(cushion)}}});
    const auto settled = [](std::uint64_t revision) {
        return [revision](const SolverOutput& output) {
            return output.designRevision == revision && output.status.state == State::Settled &&
                   output.status.resting;
        };
    };
    Listener listener;
    listener.request(input, 1);
    const auto bare = listener.waitFor(settled(1));
    ASSERT_TRUE(bare);
    EXPECT_TRUE(bare->report.cushions.empty()) << "its file is still being read";
    EXPECT_FALSE(bare->field);

    input.files.meshes[frameId] =
        std::make_shared<const TriangleMesh>(boxMesh(Box3(Vec3(20, 20, 0), Vec3(180, 180, 70))));
    listener.drawField(true);
    listener.request(input, 2);
    const auto padded = listener.waitFor(settled(2));
    ASSERT_TRUE(padded);
    EXPECT_EQ(padded->report.cushions.size(), 1u);
    EXPECT_GT(padded->surface->boundingBox().max().z(), bare->surface->boundingBox().max().z() + 2);
    ASSERT_TRUE(padded->field);
    EXPECT_FALSE(padded->field->contours.empty());
    EXPECT_FALSE(padded->field->arrows.empty());
    const SolveResult resting = solveResting(input, {});
    EXPECT_EQ(padded->surface->positions, resting.surface->positions)
        << "the resting surface is the command line's";

    cushion.strength = 0;
    input.design = input.design.with({{}, {{id, nullptr, makeElement(cushion)}}});
    listener.request(input, 3);
    const auto without = listener.waitFor(settled(3));
    ASSERT_TRUE(without);
    EXPECT_EQ(without->surface->positions, bare->surface->positions);
}

} // namespace
} // namespace bolster::test
