// C1 and G1 seams.
#include "TestDesigns.h"

#include "PreparedSheet.h"
#include "Relaxation.h"
#include "SolvePlan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster::test {
namespace {

constexpr double halfWidth = 300, height = 240; // mm
constexpr double radius = halfWidth / std::numbers::pi;

/// Two halves of a tube, sewn along both sides, both rims fixed to circles. The second one lies turned in its
/// pattern.
Design twoHalves(Continuity continuity, double edgeLength, double bendingLength)
{
    DesignBuilder b(edgeLength);
    const ElementId fabric = b.fabric(0.3, bendingLength);
    const ElementId first = b.patch(rectangle(halfWidth, height), fabric);
    const ElementId second = b.patch({{0, 0}, {0, halfWidth}, {-height, halfWidth}, {-height, 0}}, fabric);
    const auto sew = [&](Stretch a, Stretch other) {
        Seam seam;
        seam.a = a;
        seam.b = other;
        seam.reversed = true;
        seam.continuity = continuity;
        b.add(seam);
    };
    sew({first, 1, 2}, {second, 3, 4});
    sew({first, 3, 4}, {second, 1, 2});
    for (const double z : {0.0, height}) {
        const BSpline3 rim = circle(radius, z);
        const ElementId curve = b.add(FixationCurve{"Rim", rim});
        const double half = rim.period() / 2;
        for (const ElementId patch : {first, second}) {
            FixationSeam fixed;
            fixed.stretch = z == 0 ? Stretch{patch, 0, 1} : Stretch{patch, 2, 3};
            fixed.curve = curve;
            fixed.curveRange = patch == first ? std::pair(0.0, half) : std::pair(half, 2 * half);
            fixed.reversed = z > 0;
            b.add(fixed);
        }
    }
    return b.design();
}

double degreesBetween(const Vec3& a, const Vec3& b)
{
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / std::numbers::pi;
}

struct Solved {
    double kink = 0;     ///< degrees: largest angle between the two sides' frames, away from the rims
    double offRound = 0; ///< largest relative deviation from the radius there
    double twist = 0;    ///< degrees: largest angle between the two sides' directions up
    int iterations = 0;
};

Solved solve(Continuity continuity, double edgeLength, double bendingLength = 10)
{
    TriangulationCache cache;
    const std::optional<PreparedSheet> sheet =
        prepareSheet(twoHalves(continuity, edgeLength, bendingLength), cache);
    EXPECT_TRUE(sheet->errors.empty());
    WorkerPool pool(1);
    Relaxation relaxation(sheet->mesh, pool, 1e-6);
    relaxation.startCanonically();
    while (relaxation.phase() == Relaxation::Phase::Running && relaxation.iterations() < 5000)
        relaxation.iterate();
    EXPECT_EQ(relaxation.phase(), Relaxation::Phase::Converged);
    Solved result;
    result.iterations = relaxation.iterations();
    const SheetState state = relaxation.state();
    for (const SurfaceTopology::Chain& seam : sheet->mesh.topology->seams)
        for (std::size_t k = 0; k < seam.a.size(); ++k) {
            const Vec3 place = state.positions.col(sheet->mesh.topology->unknown[seam.a[k]]);
            if (place.z() < height / 3 || place.z() > height * 2 / 3)
                continue;
            const Eigen::Matrix3d a = rotationOf(state.frames.col(seam.a[k]));
            const Eigen::Matrix3d b = rotationOf(state.frames.col(seam.b[k]));
            const bool firstIsA = sheet->mesh.rest()[seam.a[k]].x() > -1e-9;
            // Up is y in the first pattern, -x in the second one.
            const Vec3 upA = firstIsA ? Vec3(a.col(1)) : Vec3(-a.col(0));
            const Vec3 upB = firstIsA ? Vec3(-b.col(0)) : Vec3(b.col(1));
            result.kink = std::max(result.kink, degreesBetween(a.col(2), b.col(2)));
            result.twist = std::max(result.twist, degreesBetween(upA, upB));
            result.offRound = std::max(result.offRound, std::abs(place.head<2>().norm() / radius - 1));
        }
    return result;
}

TEST(SmoothSeams, AreNamedInTheTopology)
{
    TriangulationCache cache;
    std::optional<PreparedSheet> sheet = prepareSheet(twoHalves(Continuity::C0, 20, 10), cache);
    ASSERT_TRUE(sheet);
    const std::shared_ptr<const SurfaceTopology> before = sheet->mesh.topology;
    EXPECT_EQ(before->seams.front().continuity, Continuity::C0);
    updateMaterials(sheet->mesh, sheet->design);
    EXPECT_EQ(sheet->mesh.topology, before) << "views keep what they have made of it";
    updateMaterials(sheet->mesh, twoHalves(Continuity::G1, 20, 10));
    EXPECT_EQ(sheet->mesh.topology->seams.front().continuity, Continuity::G1);
    EXPECT_EQ(sheet->mesh.topology->serial, before->serial) << "maps still fit";
}

TEST(SmoothSeams, RoundTheTubeOfTwoHalves)
{
    EXPECT_GT(solve(Continuity::C0, 8).kink, 20);
    for (const Continuity continuity : {Continuity::G1, Continuity::C1}) {
        const Solved smooth = solve(continuity, 8);
        EXPECT_LT(smooth.kink, 2);
        EXPECT_LT(smooth.twist, 2);
        EXPECT_LT(smooth.offRound, 0.01);
        EXPECT_LT(smooth.iterations, 200);
    }
}

/// The coupling of both sides is explicit, so it is where iterations would circle.
TEST(SmoothSeams, SettleForAnyBendingLengthAndMesh)
{
    for (const double edgeLength : {4.0, 8.0, 20.0})
        for (const double bendingLength : {2.0, 10.0, 40.0}) {
            SCOPED_TRACE(testing::Message() << edgeLength << " mm edges, bending length " << bendingLength);
            const Solved smooth = solve(Continuity::G1, edgeLength, bendingLength);
            EXPECT_LT(smooth.kink, 2);
            EXPECT_LT(smooth.offRound, 0.02);
        }
}

/// Two strips sewn to each other whose outer edges lie so far apart and tilted so far, mm: a fold that hangs on
/// hinges. Returns the iterations it takes.
int iterationsOfAFold(Continuity continuity, double apart, double tilt)
{
    constexpr double length = 300, width = 100; // mm
    constexpr int most = 1000;
    DesignBuilder b(12);
    const ElementId lower = b.patch(rectangle(length, width), b.fabric(0.3, 1, 4));
    const ElementId upper = b.patch(rectangle(length, width), b.fabric(0.3, 1, 1));
    Seam seam;
    seam.a = {lower, 2, 3};
    seam.b = {upper, 0, 1};
    seam.continuity = continuity;
    b.add(seam);
    b.fix({lower, 0, 1}, polyline({{0, 0, 0}, {length, 0, 0}}));
    b.fix({upper, 2, 3}, polyline({{length, apart, tilt}, {0, apart, -tilt}}));
    TriangulationCache cache;
    const std::optional<PreparedSheet> sheet = prepareSheet(b.design(), cache);
    WorkerPool pool(1);
    Relaxation relaxation(sheet->mesh, pool, 1e-6);
    relaxation.startCanonically();
    while (relaxation.phase() == Relaxation::Phase::Running && relaxation.iterations() < most)
        relaxation.iterate();
    return relaxation.phase() == Relaxation::Phase::Converged ? relaxation.iterations() : most;
}

TEST(SmoothSeams, OfAStiffAndASoftFabricDoNotTurnAFoldForEver)
{
    for (const Continuity continuity : {Continuity::C1, Continuity::G1})
        for (const double apart : {20.0, 60.0})
            for (const double tilt : {0.0, 30.0})
                EXPECT_LT(iterationsOfAFold(continuity, apart, tilt), 500) << apart << " mm, " << tilt;
}

/// A soft and a stiff strip in one plane, sheared together: the soft one turns further.
double turnAtTheSeam(Continuity continuity)
{
    constexpr double length = 300, width = 100, shift = 50; // mm
    DesignBuilder b(8);
    const ElementId lower = b.patch(rectangle(length, width), b.fabric(0.3, 10, 4));
    const ElementId upper = b.patch(rectangle(length, width), b.fabric(0.3, 10, 1));
    Seam seam;
    seam.a = {lower, 2, 3};
    seam.b = {upper, 0, 1};
    seam.continuity = continuity;
    b.add(seam);
    b.fix({lower, 0, 1}, polyline({{0, 0, 0}, {length, 0, 0}}));
    b.fix({upper, 2, 3}, polyline({{length + shift, 2 * width, 0}, {shift, 2 * width, 0}}));
    TriangulationCache cache;
    const std::optional<PreparedSheet> sheet = prepareSheet(b.design(), cache);
    WorkerPool pool(1);
    Relaxation relaxation(sheet->mesh, pool, 1e-6);
    relaxation.startCanonically();
    while (relaxation.phase() == Relaxation::Phase::Running)
        relaxation.iterate();
    const SheetState state = relaxation.state();
    const SurfaceTopology::Chain& chain = sheet->mesh.topology->seams.front();
    const std::size_t middle = chain.a.size() / 2;
    const Eigen::Matrix3d a = rotationOf(state.frames.col(chain.a[middle]));
    return degreesBetween(a.col(0), rotationOf(state.frames.col(chain.b[middle])).col(0));
}

TEST(SmoothSeams, OnlyC1KeepsTheTextureFromTurning)
{
    EXPECT_GT(turnAtTheSeam(Continuity::C0), 4);
    EXPECT_GT(turnAtTheSeam(Continuity::G1), 4);
    EXPECT_LT(turnAtTheSeam(Continuity::C1), 1);
}

} // namespace
} // namespace bolster::test
