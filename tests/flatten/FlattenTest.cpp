// Forms that are known when they lie flat, and the designs that are made of them.
#include "Flatten.h"

#include "ArcLength.h"
#include "DesignCheck.h"
#include "FormPattern.h"
#include "SeamSides.h"
#include "TestForms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster::test {
namespace {

constexpr double pi = std::numbers::pi;

FormPattern patternOf(const TriangleMesh& mesh, const FormCuts& cuts = {})
{
    const Form form = cutForm(mesh, cuts);
    EXPECT_EQ(problemOf(form), "");
    return formPattern(form, flatten(form, {}), {});
}

const Patch& onlyPatch(const FormPattern& pattern)
{
    EXPECT_EQ(pattern.patches.size(), 1u);
    return *pattern.design.find<Patch>(pattern.patches.front());
}

template <class T>
int countOf(const Design& design)
{
    int count = 0;
    design.each<T>([&](ElementId, const T&) { ++count; });
    return count;
}

void expectSound(const FormPattern& pattern)
{
    for (const Problem& problem : checkDesign(pattern.design))
        EXPECT_NE(problem.severity, Severity::Error)
            << problem.label << ", " << problem.field << ": " << problem.message.english();
    for (const Message& note : pattern.notes)
        ADD_FAILURE() << note.english();
}

/// On the pipe upwards is along it, sideways around it; what points at its middle lies in no direction.
/// In single precision it would come out bent: nothing but its thousands of triangles in a row keep it straight.
TEST(Flatten, AThinStripIsStraight)
{
    constexpr double length = 10000, width = 1; // mm
    const Form form =
        cutForm(gridMesh(4000, 1, [](double u, double v) { return Vec3(length * u, width * v, 0); }), {});
    const std::vector<FlatPiece> flat = flatten(form, {});
    ASSERT_EQ(flat.size(), 1u);
    double farthest = 0;
    for (const Vec2& at : flat.front().at)
        for (const Vec2& other : {flat.front().at.front(), flat.front().at.back()})
            farthest = std::max(farthest, (at - other).norm());
    EXPECT_NEAR(farthest, length, 0.01);
    EXPECT_NEAR(flat.front().area, length * width, 1);
    EXPECT_LT(flat.front().strainMost, 1e-3);
}

TEST(Flatten, GrainRunsAsAsked)
{
    const Form form = cutForm(halfPipe(100, 200), {});
    const std::vector<FlatPiece> flat = flatten(form, {});
    const auto grainFor = [&](const FormGrain& grain) {
        FormPatternOrder order;
        order.grain = grain;
        return onlyPatch(formPattern(form, flat, order)).grain;
    };
    EXPECT_EQ(grainFor({}), 90);
    EXPECT_EQ(grainFor({Vec3::UnitZ()}), 90);
    EXPECT_NEAR(std::abs(grainFor({Vec3::UnitX(), 0}) - 90), 90, 0.2) << "0 or 180: across";
    EXPECT_EQ(grainFor({Vec3::UnitY(), 90}), 90) << "in front and behind it points to opposite sides";
    EXPECT_EQ(grainFor({Vec3::Zero(), 30}), 30);
    EXPECT_NEAR(grainFor({Vec3(1, 0, 1).normalized(), 0}), 57.5, 1)
        << "between: sideways is seen shorter by 2 to pi";
}

/// As CAD programs give round faces: all triangles have a corner at one place of the border, and most are needles.
TEST(Flatten, ADiscOfNeedlesIsADisc)
{
    constexpr int corners = 1500;
    TriangleMesh disc;
    for (int k = 0; k < corners; ++k)
        disc.points.emplace_back(300 * std::cos(2 * pi * k / corners), 300 * std::sin(2 * pi * k / corners), 0);
    for (std::uint32_t k = 1; k + 1 < corners; ++k)
        disc.triangles.push_back({0, k, k + 1});
    const std::vector<FlatPiece> flat = flatten(cutForm(disc, {}), {});
    ASSERT_EQ(flat.size(), 1u);
    EXPECT_NEAR(flat[0].area, pi * 300 * 300, 10);
    EXPECT_LT(flat[0].strainMost, 1e-3);
    Box2 box;
    for (const Vec2& at : flat[0].at)
        box.extend(at);
    EXPECT_NEAR(box.sizes().x(), 600, 0.5);
    EXPECT_NEAR(box.sizes().y(), 600, 0.5);
}

TEST(Flatten, HalfAPipeIsARectangle)
{
    const Form form = cutForm(halfPipe(100, 200), {});
    const std::vector<FlatPiece> flat = flatten(form, {});
    ASSERT_EQ(flat.size(), 1u);
    EXPECT_EQ(flat[0].turnedOver, 0);
    EXPECT_LT(flat[0].strainMost, 1e-6);
    Box2 box;
    for (const Vec2& at : flat[0].at)
        box.extend(at);
    EXPECT_NEAR(box.sizes().x(), 60 * 2 * 100 * std::sin(pi / 120), 1e-3) << "the polygon's length; up is up";
    EXPECT_NEAR(box.sizes().y(), 200, 1e-3);
}

TEST(Flatten, TheOutlineOfHalfAPipeHasTheArcsLength)
{
    const FormPattern pattern = patternOf(halfPipe(100, 200));
    expectSound(pattern);
    const Patch& patch = onlyPatch(pattern);
    EXPECT_NEAR(patch.outline.boundingBox().sizes().y(), 200, 0.01);
    EXPECT_LE(patch.outline.pointCount(), 12) << "a rectangle needs no more";
    EXPECT_EQ(countOf<FixationCurve>(pattern.design), 2) << "all around is divided once, as curves have ends";
}

TEST(Flatten, AConeIsASectorOfARing)
{
    // A frustum with slant height s: the sector spans 2 pi (r2 - r1) / s.
    const double lower = 150, upper = 90, height = 80, slant = std::hypot(height, lower - upper);
    const FormPattern pattern = patternOf(ringMesh(lower, upper, height));
    expectSound(pattern);
    const Patch& patch = onlyPatch(pattern);
    EXPECT_NEAR(std::abs(patch.outline.signedArea()), pi * (lower + upper) * slant,
                0.002 * pi * (lower + upper) * slant);
    ASSERT_EQ(pattern.seams.size(), 1u) << "where it was cut open";
    EXPECT_NEAR(pattern.seams[0].first, slant, 0.05);
    EXPECT_NEAR(pattern.seams[0].second, slant, 0.05);
}

/// A dome of two halves that cannot be laid flat without strain. Of few triangles smooth outlines through their
/// corners bow differently on both sides of a seam.
TEST(Flatten, SewnEdgesAreEquallyLongThoughTheirPiecesAreStrained)
{
    for (const int columns : {6, 10, 30}) {
        const auto dome = [&](double from) {
            return gridMesh(
                columns, columns / 2,
                [from](double u, double v) {
                    const double around = pi * (from + u), high = 0.5 * pi * v * 0.95;
                    return Vec3(100 * std::cos(around) * std::cos(high), 100 * std::sin(around) * std::cos(high),
                                70 * std::sin(high));
                },
                from == 0 ? "Back" : "Front");
        };
        const FormPattern pattern = patternOf(sideBySide(dome(0), dome(1)));
        expectSound(pattern);
        ASSERT_GE(pattern.seams.size(), 2u);
        for (const FormSeam& seam : pattern.seams)
            EXPECT_NEAR(seam.first, seam.second, 0.01) << columns;
    }
}

/// Two squares, of which one bows where they are sewn to each other.
TEST(SeamSides, BecomeEquallyLongAndStraightEdgesStayStraight)
{
    const auto square = [](double from, const std::string& name) {
        return gridMesh(
            3, 3, [=](double u, double v) { return Vec3(100 * (from + u), 100 * v, 0); }, name);
    };
    const Form form = cutForm(sideBySide(square(0, "Straight"), square(1, "Bowed")), {true, {}, {}, {}});
    ASSERT_EQ(form.pieces.size(), 2u);
    const auto line = [](const Vec2& from, const Vec2& to) {
        return BSpline2(3, false, {from, from + (to - from) / 3, to - (to - from) / 3, to});
    };
    std::vector<PieceCurves> pieces;
    for (const FormPiece& piece : form.pieces) {
        ASSERT_EQ(piece.rows.size(), 2u);
        const bool bows = piece.name == "Bowed";
        const BSpline2 sewn =
            bows ? BSpline2(3, false, {{0, 0}, {30, -6}, {70, -6}, {100, 0}}) : line({0, 0}, {100, 0});
        std::vector<BSpline2> border{line({100, 0}, {100, 100}), line({100, 100}, {0, 100}),
                                     line({0, 100}, {0, 0})};
        const bool first = piece.rows.front().isSewn();
        border.insert(first ? border.begin() : border.end(), sewn);
        pieces.push_back({border, {0, first ? 1u : 3u}});
    }
    const auto lengthOf = [&](std::size_t p, bool sewn) {
        const bool first = form.pieces[p].rows.front().isSewn();
        double length = 0;
        for (std::size_t c = 0; c < 4; ++c)
            if ((c == (first ? 0u : 3u)) == sewn)
                length += ArcLength2(pieces[p].curves[c]).total();
        return length;
    };
    ASSERT_GT(std::abs(lengthOf(0, true) - lengthOf(1, true)), 0.5);
    makeSidesEqual(form, pieces);
    EXPECT_NEAR(lengthOf(0, true), lengthOf(1, true), 0.01);
    for (const std::size_t p : {0u, 1u}) {
        EXPECT_NEAR(lengthOf(p, false), 300, 0.01);
        for (std::size_t c = 0; c < 4; ++c) {
            const std::vector<Vec2>& points = pieces[p].curves[c].points();
            EXPECT_EQ(points.back(), pieces[p].curves[(c + 1) % 4].points().front());
            const Vec2 way = (points.back() - points.front()).normalized(), off = points[1] - points[0];
            if (form.pieces[p].name == "Straight") {
                EXPECT_NEAR(way.x() * off.y() - way.y() * off.x(), 0, 1e-9) << c;
            }
        }
    }
}

TEST(Flatten, SaysWhereThePieceIsStrainedMost)
{
    // A plane with a bump near one corner.
    const Form form = cutForm(gridMesh(40, 40,
                                       [](double u, double v) {
                                           const double far = std::hypot(u - 0.25, v - 0.7);
                                           return Vec3(400 * u, 400 * v, 60 * std::exp(-far * far / 0.01));
                                       }),
                              {});
    const std::vector<FlatPiece> flat = flatten(form, {});
    ASSERT_EQ(flat.size(), 1u);
    EXPECT_GT(flat[0].strainMost, 0.05);
    EXPECT_LT((flat[0].strainedAt.head<2>() - Vec2(100, 280)).norm(), 60);
}

/// Two sheets with the same border are a closed form.
TEST(Flatten, SaysBeforehandWhatWillBeWrongWithTheCover)
{
    const auto half = [](double way) {
        return gridMesh(
            20, 20,
            [&](double u, double v) {
                const double across = way > 0 ? u : 1 - u;
                return Vec3(300 * across, 300 * v, way * 30 * std::sin(pi * across) * std::sin(pi * v));
            },
            way > 0 ? "Top" : "Bottom");
    };
    const FormPattern closed = patternOf(sideBySide(half(1), half(-1)));
    expectSound(closed);
    EXPECT_EQ(closed.seams.size(), 4U) << "corner to corner";
    ASSERT_EQ(closed.advice.size(), 1U);
    EXPECT_TRUE(closed.advice[0].english().starts_with("What is closed all around")) << closed.advice[0].english();
    int fixations = 0;
    closed.design.each<FixationSeam>([&](ElementId, const FixationSeam&) { ++fixations; });
    EXPECT_EQ(fixations, 4) << "it is held along its seams";
    EXPECT_TRUE(patternOf(half(1)).advice.empty());

    FormPatternOrder order;
    order.edgeLength = 80;
    const Form form = cutForm(half(1), {});
    const FormPattern coarse = formPattern(form, flatten(form, {}), order);
    ASSERT_EQ(coarse.advice.size(), 1U);
    EXPECT_NE(coarse.advice[0].english().find("80 mm long: Top."), std::string::npos) << coarse.advice[0].english();
    EXPECT_NE(coarse.advice[0].english().find("edges of 75.9 mm"), std::string::npos) << coarse.advice[0].english();
}

/// Shorter edges for a speck would make a cover of so many triangles that longer ones are advised.
TEST(Flatten, SmallPiecesAreNamedAndSpecksAskForNoShorterEdges)
{
    const auto square = [](double size, double x, const std::string& name) {
        return gridMesh(
            10, 10, [&](double u, double v) { return Vec3(x + size * u, size * v, 0); }, name);
    };
    const FormPattern made = patternOf(
        sideBySide(sideBySide(square(1000, 0, "Seat"), square(31, 2000, "Tab")), square(15, 3000, "Speck")));
    ASSERT_EQ(made.advice.size(), 2U);
    const std::string small = made.advice[0].english(), speck = made.advice[1].english();
    EXPECT_NE(small.find("12 mm long: Tab. "), std::string::npos) << small;
    EXPECT_NE(small.find("mesh edges of 7.7 mm"), std::string::npos) << small;
    EXPECT_NE(speck.find("12 mm long: Speck. Join"), std::string::npos) << speck;
    EXPECT_EQ(speck.find("mesh edges"), std::string::npos) << speck;
}

TEST(Flatten, PiecesThatAreWiderThanTheFabricAreNamed)
{
    const Form form = cutForm(gridMesh(
                                  20, 10, [](double u, double v) { return Vec3(1500 * u, 0, 300 * v); }, "Back"),
                              {});
    const std::vector<FlatPiece> flat = flatten(form, {});
    FormPatternOrder order;
    order.edgeLength = 40;
    const FormPattern upright = formPattern(form, flat, order);
    ASSERT_EQ(upright.advice.size(), 1U);
    EXPECT_NE(upright.advice[0].english().find("1400 mm can be used: Back."), std::string::npos)
        << upright.advice[0].english();
    order.grain = FormGrain::side();
    EXPECT_TRUE(formPattern(form, flat, order).advice.empty()) << "it is as long as one likes along the grain";
    order.grain = {};
    order.fabric.cutting.width = 1600;
    EXPECT_TRUE(formPattern(form, flat, order).advice.empty());
}

TEST(Flatten, APieceOfAPlaneStaysAsItIsWhateverTheFabric)
{
    for (const double poisson : {-0.4, 0.0, 0.45}) {
        const Form form =
            cutForm(gridMesh(20, 10, [](double u, double v) { return Vec3(300 * u, 200 * v, 0); }), {});
        FlattenOrder order;
        order.poisson = poisson;
        const std::vector<FlatPiece> flat = flatten(form, order);
        EXPECT_LT(flat[0].strainMost, 1e-9);
        EXPECT_NEAR(flat[0].area, 60'000, 1e-3);
    }
}

TEST(Flatten, SeamsThatHardlyBendAreRounded)
{
    const auto half = [](double from, const std::string& name) {
        return gridMesh(
            20, 10,
            [from](double u, double v) {
                const double angle = pi * (1 + from + 0.5 * u);
                return Vec3(100 * std::cos(angle), 100 * std::sin(angle), 150 * v);
            },
            name);
    };
    const FormPattern smooth = patternOf(sideBySide(half(0, "Left"), half(0.5, "Right")));
    ASSERT_EQ(smooth.seams.size(), 1u);
    EXPECT_EQ(smooth.design.find<Seam>(smooth.seams[0].seam)->continuity, Continuity::G1);
    const auto plane = [](const Vec3& along, const std::string& name, bool swap) {
        return gridMesh(
            10, 10, [=](double u, double v) { return Vec3((swap ? 1 - u : u) * along + Vec3(0, 0, 100 * v)); },
            name);
    };
    const FormPattern edge = patternOf(sideBySide(plane({100, 0, 0}, "A", false), plane({0, 100, 0}, "B", true)));
    ASSERT_EQ(edge.seams.size(), 1u);
    EXPECT_EQ(edge.design.find<Seam>(edge.seams[0].seam)->continuity, Continuity::C0);
}

/// A plate of few triangles: a long straight edge goes on in short ones that bend by some 15 degrees each.
TEST(Flatten, ALongEdgeBesideShortOnesStaysStraight)
{
    TriangleMesh plate;
    plate.points = {{0, 0, 0}, {700, 0, 0}, {730, 8, 0}, {755, 22, 0}, {770, 100, 0}, {0, 100, 0}};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    const Form form = cutForm(plate, {});
    ASSERT_EQ(form.pieces.size(), 1U);
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    const auto* patch = made.design.find<Patch>(made.patches.at(0));
    ASSERT_TRUE(patch);
    EXPECT_NEAR(std::abs(patch->outline.signedArea()), 75590, 0.005 * 75590);
    const Box2 box = patch->outline.boundingBox();
    EXPECT_NEAR(box.sizes().maxCoeff(), 770, 3);
    EXPECT_NEAR(box.sizes().minCoeff(), 100, 3);
}

/// Corners that turn by 30 degrees and less, between straight lines of many points.
TEST(Flatten, BluntCornersBetweenStraightLinesStayCorners)
{
    const std::vector<Vec3> corners{{0, 0, 0},     {300, 0, 0},   {380, 46, 0},
                                    {400, 100, 0}, {400, 300, 0}, {0, 300, 0}};
    TriangleMesh plate;
    plate.points.emplace_back(200, 150, 0);
    constexpr int parts = 5;
    for (std::size_t k = 0; k < corners.size(); ++k)
        for (int i = 0; i < parts; ++i)
            plate.points.emplace_back(corners[k] +
                                      i * (corners[(k + 1) % corners.size()] - corners[k]) / double(parts));
    const auto around = static_cast<std::uint32_t>(plate.points.size()) - 1;
    for (std::uint32_t k = 0; k < around; ++k)
        plate.triangles.push_back({0, 1 + k, 1 + (k + 1) % around});
    const Form form = cutForm(plate, {});
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    const auto* patch = made.design.find<Patch>(made.patches.at(0));
    ASSERT_TRUE(patch);
    EXPECT_NEAR(std::abs(patch->outline.signedArea()), 116700, 0.1);
    EXPECT_EQ(patch->outline.corners().size(), corners.size());
}

/// A dozen edges of 100 mm are what the form has; of a dozen of 5 mm a curve is as near as anyone sews.
TEST(Flatten, CoarseOutlinesKeepTheirCorners)
{
    for (const auto& [radius, corners] : {std::pair(200.0, 12U), std::pair(10.0, 0U)}) {
        const Form form = cutForm(ringMesh(radius, radius / 2, radius / 4, 12, 1), {});
        const FormPattern made = formPattern(form, flatten(form, {}), {});
        ASSERT_EQ(made.seams.size(), 1U);
        const Patch* patch = made.design.find<Patch>(made.patches.front());
        ASSERT_TRUE(patch);
        double area = 0;
        for (const FlatPiece& flat : flatten(form, {}))
            area += flat.area;
        EXPECT_GE(patch->outline.corners().size(), corners > 0 ? 26U : 4U) << radius;
        EXPECT_NEAR(std::abs(patch->outline.signedArea()), area, (corners > 0 ? 0.003 : 0.05) * area) << radius;
    }
}

} // namespace
} // namespace bolster::test
