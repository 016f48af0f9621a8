#include "CutPattern.h"

#include "CutCheck.h"
#include "DartEdits.h"
#include "ElementEdits.h"
#include "Growth.h"
#include "Panels.h"

#include <gtest/gtest.h>

namespace bolster {

namespace {

using namespace test;

const CutPiece& pieceOf(const CutPattern& pattern, ElementId patch)
{
    const auto found = std::ranges::find(pattern.pieces, patch, &CutPiece::patch);
    EXPECT_NE(found, pattern.pieces.end());
    return *found;
}

Design withSettings(const Design& design, const DesignCutting& cutting)
{
    Settings settings = design.settings();
    settings.cutting = cutting;
    return with(design, settingsId, settings);
}

} // namespace

TEST(CutPattern, AHoleSaysWhereADartEnds)
{
    const Design design = twoPanels();
    const Design narrow = design.with(edits::addDart(design, {left, 0.45, 0.55, {100, 60}}));
    const CutPiece piece = pieceOf(cutPattern(narrow, {}), left);
    ASSERT_EQ(piece.holes.size(), 1u);
    EXPECT_NEAR((piece.holes[0].at - Vec2(100, 60)).norm(), 10, 1e-6) << "short of the tip";
    EXPECT_LT(piece.holes[0].at.y(), 60) << "between the legs";
    // One that somebody has drilled there is enough.
    const Design own =
        narrow.with(edits::addElement(narrow, makeElement(DrillHole{"Tip", {left, Vec2(100, 58)}, 3})));
    const CutPiece drilled = pieceOf(cutPattern(own, {}), left);
    ASSERT_EQ(drilled.holes.size(), 1u);
    EXPECT_EQ(drilled.holes[0].name, "Tip");
}

TEST(CutPattern, NotesAreBrokenIntoLines)
{
    Design design = twoPanels();
    Patch noted = *design.find<Patch>(left);
    noted.cutting.note = "Tie-down strip 12 mm on the inside; watch scars and mirror";
    design = with(design, left, noted);
    const CutPiece piece = pieceOf(cutPattern(design, {}), left);
    const std::vector<std::string>& lines = piece.label.lines;
    const auto begin = std::ranges::find(lines, "Tie-down strip 12 mm on the");
    ASSERT_NE(begin, lines.end());
    EXPECT_EQ(std::vector<std::string>(begin + 1, lines.end()),
              (std::vector<std::string>{"inside; watch scars and", "mirror"}));
}

TEST(CutPattern, TakesTheAllowanceThatIsNearest)
{
    const Design design = twoPanels();
    EXPECT_EQ(allowanceOf(design, *design.find<Patch>(left)).width, 10) << "nobody says any";
    EXPECT_EQ(allowanceOf(design, *design.find<Patch>(left), 7).width, 7) << "who exports says it";
    DesignCutting cutting;
    cutting.allowance = CutAllowance{12};
    const Design said = withSettings(design, cutting);
    EXPECT_EQ(allowanceOf(said, *said.find<Patch>(left), 7).width, 12) << "the design says it";
    Patch own = *said.find<Patch>(left);
    own.allowance = CutAllowance{3, CornerJoin::Rounded};
    const Design both = with(said, left, own);
    EXPECT_EQ(allowanceOf(both, *both.find<Patch>(left), 7).width, 3) << "the patch says it";

    const CutPattern pattern = cutPattern(with(both, ElementId{9}, EdgeAllowance{{left, 1, 2}, 20}), {});
    EXPECT_NEAR(pieceOf(pattern, left).box().max().x(), 220, 1e-3) << "the edge says it";
    EXPECT_NEAR(pieceOf(pattern, left).box().min().x(), -3, 1e-3);
    EXPECT_NEAR(pieceOf(pattern, right).box().max().x(), 212, 1e-3);
}

TEST(CutPattern, OfAnOutlineThatRunsClockwiseIsTheSame)
{
    Design design = twoPanels();
    Patch turned = *design.find<Patch>(left);
    turned.outline = turned.outline.reversed();
    // The right edge was 1 to 2; of four edges that is 2 to 3 now.
    const CutPiece before =
        pieceOf(cutPattern(with(design, ElementId{9}, EdgeAllowance{{left, 1, 2}, 20}), {}), left);
    const CutPiece after = pieceOf(
        cutPattern(with(with(design, left, turned), ElementId{9}, EdgeAllowance{{left, 2, 3}, 20}), {}), left);
    EXPECT_NEAR(areaOf(before.cut), areaOf(after.cut), 1e-3);
    EXPECT_TRUE(before.box().isApprox(after.box(), 1e-6));
}

TEST(CutPattern, PutsNotchesOnTheCutLineAcrossFromWhereTheyMeet)
{
    DesignCutting cutting;
    cutting.notches.spacing = 50;
    const CutPattern pattern = cutPattern(withSettings(twoPanels(), cutting), {});
    bool seen = false;
    for (const CutNotch& notch : pieceOf(pattern, left).notches)
        if (std::abs(notch.fraction - 0.5) < 1e-9) {
            EXPECT_TRUE(notch.sewn.isApprox(Vec2(200, 50), 1e-6));
            EXPECT_TRUE(notch.at.isApprox(Vec2(210, 50), 1e-6));
            EXPECT_TRUE(notch.inwards.isApprox(Vec2(-1, 0), 1e-6));
            seen = true;
        }
    EXPECT_TRUE(seen);
}

TEST(CutPattern, IsLargerByWhatTheFabricShrinks)
{
    Design design = twoPanels();
    Fabric fabric = *design.find<Fabric>(leather);
    fabric.cutting.shrinkAlong = 20; // the grain runs up
    fabric.cutting.shrinkAcross = 50;
    const CutPiece piece = pieceOf(cutPattern(with(design, leather, fabric), {}), left);
    Box2 sewn;
    for (const LinePoint& point : piece.sew)
        sewn.extend(point.at);
    EXPECT_TRUE(sewn.sizes().isApprox(Vec2(400, 125), 1e-9));
    EXPECT_TRUE(piece.box().sizes().isApprox(Vec2(420, 145), 1e-6)) << "the allowance is what is cut";
    const BSpline2 outline = design.find<Patch>(left)->outline;
    for (const LinePoint& point : piece.sew)
        EXPECT_LT(outline.closest(piece.shrunk(point.at)).distance, 1e-9) << "it shrinks to what was drawn";
    const CutPiece mirrored = mirroredPiece(piece);
    EXPECT_TRUE(mirrored.shrunk(mirrored.sew.front().at)
                    .isApprox(piece.shrunk({-mirrored.sew.front().at.x(), mirrored.sew.front().at.y()})));
    Patch labelled = *design.find<Patch>(left);
    labelled.cutting.label = PieceLabelPlace{{120, 40}, 0};
    const CutPiece placed = pieceOf(cutPattern(with(with(design, leather, fabric), left, labelled), {}), left);
    EXPECT_TRUE(placed.shrunk(placed.label.at).isApprox(Vec2(120, 40), 1e-9)) << "labels shrink with it";
}

TEST(CutPattern, UnfoldsPairs)
{
    Design design = twoPanels();
    Patch paired = *design.find<Patch>(left);
    paired.cutting.pair = true;
    paired.cutting.quantity = 2;
    design = with(design, left, paired);
    EXPECT_EQ(cutPattern(design, {}).pieces.size(), 2u);
    CutOptions options;
    options.unfold = true;
    const CutPattern pattern = cutPattern(design, options);
    ASSERT_EQ(pattern.pieces.size(), 3u);
    EXPECT_FALSE(pattern.pieces[0].mirrored);
    EXPECT_TRUE(pattern.pieces[1].mirrored);
    EXPECT_EQ(pattern.pieces[1].quantity, 2);
    EXPECT_FALSE(pattern.pieces[1].pair);
    EXPECT_NEAR(pattern.pieces[1].box().min().x(), -210, 1e-3);
    EXPECT_GT(areaOf(pattern.pieces[1].cut), 0) << "counter-clockwise, too";
}

TEST(CutPattern, ShowsTheRightSideOfWhatIsWornWrongSideOut)
{
    Design design = twoPanels();
    Patch turned = *design.find<Patch>(left);
    turned.wrongSideOut = true;
    const CutPiece piece = pieceOf(cutPattern(with(design, left, turned), {}), left);
    EXPECT_NEAR(piece.box().min().x(), -210, 1e-3);
    EXPECT_FALSE(piece.mirrored) << "it is no second one of a pair";
}

TEST(CutPattern, HasHolesLinesAndALabelInside)
{
    InternalLine line;
    line.patch = left;
    line.name = "Tie";
    line.use = LineUse::Cut;
    line.curve = BSpline2(1, false, {{20, 20}, {180, 20}});
    InternalLine hidden = line;
    hidden.use = LineUse::Ignored;
    DrillHole hole;
    hole.place = {left, {30, 80}};
    Design design = with(with(with(twoPanels(), ElementId{9}, line), ElementId{10}, hidden), ElementId{11}, hole);
    CutOptions options;
    options.style = "Chair";
    const CutPiece piece = pieceOf(cutPattern(design, options), left);
    ASSERT_EQ(piece.inner.size(), 1u);
    EXPECT_TRUE(piece.inner[0].cut);
    ASSERT_EQ(piece.holes.size(), 1u);
    EXPECT_TRUE(piece.label.fits);
    EXPECT_EQ(piece.label.lines, (std::vector<std::string>{"Left", "Cut 1", "Leather", "Chair"}));
    EXPECT_TRUE(isInside(piece.sew, piece.label.at));
    EXPECT_NEAR((piece.grain.to - piece.grain.from).normalized().y(), 1, 1e-9);
}

TEST(CutPattern, LabelsThatFindNoRoomSaySo)
{
    Design design = twoPanels();
    Patch strip = *design.find<Patch>(left);
    strip.outline = rectangle(200, 3);
    const CutPiece piece = pieceOf(cutPattern(with(design, left, strip), {}), left);
    EXPECT_FALSE(piece.label.fits);
    strip.outline = rectangle(200, 40);
    strip.cutting.label = PieceLabelPlace{{100, 20}, 0};
    EXPECT_TRUE(pieceOf(cutPattern(with(design, left, strip), {}), left).label.fits);
}

TEST(CutPattern, LeavesOutWhatHasNoOutline)
{
    Design design = twoPanels();
    Patch crossed = *design.find<Patch>(left);
    crossed.outline = BSpline2(1, true, {{0, 0}, {100, 100}, {100, 0}, {0, 100}});
    const CutPattern pattern = cutPattern(with(design, left, crossed), {});
    EXPECT_EQ(pattern.leftOut, (std::vector{left}));
    EXPECT_EQ(pattern.pieces.size(), 1u);
}

namespace {

/// Panels in a row, each with its marks, sewn to the next one.
Design manyPanels(int count)
{
    Edit edit;
    Fabric fabric;
    fabric.name = "Leather";
    edit.changes.push_back({ElementId(1), nullptr, makeElement(fabric)});
    int id = 2;
    ElementId before{};
    for (int k = 0; k < count; ++k) {
        const auto patch = ElementId(id++);
        Patch panel;
        panel.name = "Panel";
        panel.fabric = ElementId(1);
        panel.outline = test::rectangle(200, 100);
        edit.changes.push_back({patch, nullptr, makeElement(panel)});
        edit.changes.push_back({ElementId(id++), nullptr, makeElement(EdgeAllowance{{patch, 0, 1}, 20})});
        edit.changes.push_back({ElementId(id++), nullptr, makeElement(DrillHole{"", {patch, {50, 50}}, 3})});
        edit.changes.push_back({ElementId(id++), nullptr, makeElement(Notch{{patch, 1.3}, {}, false})});
        if (k > 0)
            edit.changes.push_back({ElementId(id++), nullptr, makeElement(Seam{{before, 1, 2}, {patch, 3, 4}})});
        before = patch;
    }
    return Design().with(edit);
}

} // namespace

TEST(CutPattern, OfManyPiecesTakesAsMuchLonger)
{
    const auto cut = [](const Design& design) { return checkCutting(design, cutPattern(design, {})); };
    EXPECT_LT(test::growth(60, manyPanels, cut), test::nearlyLinear);
}

TEST(CutPattern, IsGivenUpWhenNobodyWantsIt)
{
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(cutPattern(manyPanels(50), {}, stop.get_token()).pieces.empty());
}

} // namespace bolster
