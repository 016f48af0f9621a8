#include "PatternScene.h"
#include "CurvePath.h"
#include "DartEdits.h"
#include "ElementEdits.h"
#include "PatchEdits.h"
#include "SeamColors.h"
#include "StretchLength.h"
#include "TestDesigns.h"

#include <QTransform>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {
namespace {

using Kind = PatternHit::Kind;

TEST(CurvePath, RunsThroughTheCurve)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 9; ++i)
        points.emplace_back(100 * std::cos(0.7 * i), 80 * std::sin(0.7 * i));
    const BSpline2 curve = BSpline2::withCorners(points, {0, 4});
    // Beyond the end of the domain and back to its start, as a stretch does that passes it.
    const double from = 6.3;
    const double to = 11.6;
    const QPainterPath path = curvePath(curve, from, to, [](const Vec2& p) { return p; });
    EXPECT_LT((toVec(path.elementAt(0)) - curve.at(from)).norm(), 1e-9);
    EXPECT_LT((toVec(path.currentPosition()) - curve.at(curve.wrapped(to))).norm(), 1e-9);
    for (int i = 0; i <= 200; ++i)
        EXPECT_LT(curve.closest(toVec(path.pointAtPercent(i / 200.0))).distance, 1e-3);
}

TEST(PatternScene, HitsPointsBeforeOutlinesBeforeTheInside)
{
    PatternScene scene;
    scene.reset(twoSquares());
    const auto all = [](ElementId) { return true; };
    const auto none = [](ElementId) { return false; };
    EXPECT_EQ(scene.hit({2, 1}, 5, all).kind, Kind::Point);
    EXPECT_EQ(scene.hit({2, 1}, 5, all).point, 0);
    EXPECT_EQ(scene.hit({2, 1}, 5, none).kind, Kind::Outline);
    EXPECT_EQ(scene.hit({50, 50}, 5, all).kind, Kind::Inside);
    EXPECT_EQ(scene.hit({50, 50}, 5, all).patch, firstSquare);
    EXPECT_EQ(scene.hit({150, 50}, 5, all).kind, Kind::Nothing);
}

/// An outline with a dart begins elsewhere than at 0, from where its stretches are counted.
TEST(PatternScene, ShowsAllThatIsSewnBesideADart)
{
    const Design before = twoSquares();
    const BSpline2& square = before.find<Patch>(firstSquare)->outline;
    for (const double middle : {0.5, 1.5, 2.5, 3.5}) {
        const Vec2 at = square.at(middle), tip = at + 0.5 * (square.boundingBox().center() - at);
        const Design design = before.with(edits::addDart(before, {firstSquare, middle - 0.1, middle + 0.1, tip}));
        PatternScene scene;
        scene.reset(design);
        int seams = 0, shown = 0;
        design.each<Seam>([&](ElementId, const Seam&) { ++seams; });
        for (const auto& [owner, stretch] : scene.stretches()) {
            const Seam* of = design.find<Seam>(owner);
            if (!of)
                continue;
            ++shown;
            double nearest = 1e9;
            for (const Stretch& side : {of->a, of->b})
                nearest = std::min(nearest, std::abs(stretchLength(design, side) - stretch.path.length()));
            EXPECT_LT(nearest, 0.1) << middle;
        }
        EXPECT_EQ(shown, 2 * seams) << middle;
        EXPECT_GE(seams, 2) << middle;
    }
}

/// Of a hundred thousand patches nobody reads the names.
TEST(PatternScene, LooksForRoomForANameOnlyWhereOneIsWritten)
{
    PatternScene scene;
    const Design before = twoSquares();
    scene.reset(before);
    const PatternPatch& patch = *scene.patch(firstSquare);
    EXPECT_FALSE(patch.knownLabel);
    const auto place = patch.label().place({40, 10});
    ASSERT_TRUE(place);
    Patch moved = patch.patch();
    moved.position += Vec2(30, 5);
    const Design after = before.with({{}, {{firstSquare, before.element(firstSquare), makeElement(moved)}}});
    scene.update(after, {firstSquare});
    EXPECT_TRUE(patch.knownLabel) << "and goes with it";
    EXPECT_LT((patch.label().place({40, 10})->centre - place->centre - Vec2(30, 5)).norm(), 1e-9);
    moved.outline = BSpline2(1, true, {{0, 0}, {20, 0}, {20, 20}, {0, 20}});
    scene.update(after.with({{}, {{firstSquare, after.element(firstSquare), makeElement(moved)}}}), {firstSquare});
    EXPECT_FALSE(patch.label().place({40, 10})) << "no room any more";
}

TEST(PatternScene, FindsTheSeamAtAnOutline)
{
    PatternScene scene;
    scene.reset(twoSquares());
    const auto none = [](ElementId) { return false; };
    const PatternHit sewn = scene.hit({100, 40}, 5, none);
    EXPECT_EQ(sewn.seam, squareSeam);
    EXPECT_EQ(sewn.element(), squareSeam);
    EXPECT_NEAR(sewn.parameter, 1.4, 1e-6);
    EXPECT_EQ(scene.hit({40, 0}, 5, none).seam, noElement);
    EXPECT_EQ(scene.hit({300, 60}, 5, none).seam, squareFixation);
}

TEST(PatternScene, FollowsTheDesign)
{
    Design design = twoSquares();
    PatternScene scene;
    scene.reset(design);
    EXPECT_TRUE(scene.boundingBox().isApprox(Box2(Vec2(0, 0), Vec2(300, 100))));

    const Edit turned = edits::turnPatches(design, std::array{secondSquare}, Vec2(250, 50), 45);
    const Design moved = design.with(turned);
    scene.update(moved, differences(design, moved));
    EXPECT_NEAR(scene.boundingBox().max().x(), 250 + 50 * std::sqrt(2), 1e-6);
    EXPECT_EQ(scene.stretches().size(), 3U);

    const Edit removed = edits::removeElements(moved, std::array{secondSquare});
    const Design less = moved.with(removed);
    scene.update(less, differences(moved, less));
    EXPECT_EQ(scene.patches().size(), 1U);
    EXPECT_TRUE(scene.stretches().empty());
}

TEST(PatternScene, KeepsLabelsInside)
{
    PatternScene scene;
    scene.reset(twoSquares());
    const LabelPlace& label = scene.patch(firstSquare)->label();
    const auto place = label.place({90, 20});
    ASSERT_TRUE(place);
    EXPECT_EQ(place->angle, 0);
    EXPECT_LT((place->centre - Vec2(50, 50)).norm(), 8);
    EXPECT_FALSE(label.place({120, 10}));
}

/// All corners of the line's box lie inside.
void expectInside(const QPolygonF& outline, const LabelPlace::Place& place, const QSizeF& text)
{
    const Eigen::Rotation2Dd turn(place.angle);
    for (const Vec2& corner : {Vec2(1, 1), Vec2(1, -1), Vec2(-1, -1), Vec2(-1, 1)}) {
        const Vec2 at = place.centre + turn * corner.cwiseProduct(Vec2(text.width() / 2, text.height() / 2));
        EXPECT_TRUE(outline.containsPoint(QPointF(at.x(), at.y()), Qt::OddEvenFill)) << at.transpose();
    }
}

TEST(LabelPlace, IsInTheMiddleOfWhatIsWiderAtOneEnd)
{
    // Much room at the lower end, enough in the middle.
    const QPolygonF wedge({{0, 0}, {300, 0}, {210, 900}, {90, 900}, {0, 0}});
    const QSizeF text(110, 30);
    const auto place = LabelPlace::inside(wedge).place(text);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->angle, 0);
    EXPECT_NEAR(place->centre.y(), 400, 60) << "not at an end";
    EXPECT_NEAR(place->centre.x(), 150, 25);
    expectInside(wedge, *place, text);
}

TEST(LabelPlace, LeansWithAPatchThatLeans)
{
    // A strip at 60 degrees in which a lying or upright line has no room.
    QTransform turn;
    turn.rotate(60);
    const QPolygonF strip = turn.map(QPolygonF({{0, 0}, {400, 0}, {400, 60}, {0, 60}, {0, 0}}));
    const QSizeF text(160, 24);
    const auto place = LabelPlace::inside(strip).place(text);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->angle, M_PI / 3, 0.05);
    expectInside(strip, *place, text);
    const QPointF middle = turn.map(QPointF(200, 30));
    EXPECT_LT((place->centre - Vec2(middle.x(), middle.y())).norm(), 15);
}

TEST(LabelPlace, AFlatStripTakesALongName)
{
    const QPolygonF strip({{0, 0}, {150, 0}, {150, 26}, {0, 26}, {0, 0}});
    const auto place = LabelPlace::inside(strip).place({120, 20});
    ASSERT_TRUE(place);
    expectInside(strip, *place, {120, 20});
}

TEST(SeamColors, DifferAtOnePatch)
{
    Design design = twoSquares();
    for (int side = 0; side < 3; ++side) {
        const Seam seam{{firstSquare, side + 0.1, side + 0.2}, {secondSquare, side + 0.3, side + 0.4}};
        design = design.with(edits::addElement(design, makeElement(seam)));
    }
    const std::map<ElementId, QColor> colors = seamColors(design, false);
    EXPECT_EQ(colors.size(), 4U);
    std::set<QRgb> different;
    for (const auto& [id, color] : colors)
        different.insert(color.rgb());
    EXPECT_EQ(different.size(), 4U);
    EXPECT_EQ(colors, seamColors(design, false));
}

} // namespace
} // namespace bolster
