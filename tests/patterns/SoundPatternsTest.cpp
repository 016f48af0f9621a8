// What comes in has no mistakes, and whatever is left out or made otherwise is told.
#include "DesignCheck.h"
#include "Drawn.h"
#include "PatternDesign.h"

#include <numbers>

namespace bolster {

using namespace test;

namespace {

struct Imported {
    FoundPattern found;
    ImportedPattern made;
    Design design;

    explicit Imported(const Drawing& drawing, double unit = 1, const Design& start = Design())
        : found(findPieces(drawing, {unit, "", 0}))
        , made(patternEdit(start, found))
        , design(start.with(made.edit))
    {
        for (const Problem& problem : checkDesign(design))
            if (problem.severity == Severity::Error)
                ADD_FAILURE() << problem.label << " " << problem.field << " " << problem.message.english();
        EXPECT_EQ(made.taken.size(), made.patches.size());
    }

    bool tells(const std::string& words) const
    {
        for (const Message& note : made.notes)
            if (note.english().find(words) != std::string::npos)
                return true;
        for (const Message& note : made.notes)
            ADD_FAILURE() << note.english();
        return false;
    }
    const Patch& patch() const { return *design.find<Patch>(made.patches.at(0)); }
};

/// A star with so many points that each is a corner.
DrawnLine star(int points)
{
    std::vector<Vec2> places;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * i / points, radius = i % 2 == 0 ? 1000 : 999.8;
        places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return lineOf("1", places, true);
}

Drawing labelled(const std::string& key, const std::string& value)
{
    Drawing drawing;
    DrawnPart part;
    part.name = "Seat";
    part.lines.push_back(rectangleOf("1", {0, 0}, {400, 300}));
    part.texts.push_back({"1", {0, 0}, key + value});
    drawing.parts.push_back(std::move(part));
    return drawing;
}

} // namespace

TEST(SoundPatterns, OutlinesOfTooManyPointsAreSimplified)
{
    const Imported imported(drawingWith({star(9000)}));
    ASSERT_EQ(imported.made.patches.size(), 1u);
    EXPECT_LE(imported.patch().outline.pointCount(), mostCurvePoints);
    EXPECT_TRUE(imported.tells("simplified"));
    EXPECT_NEAR(imported.patch().outline.signedArea(), std::numbers::pi * 1e6, 4e3);
}

TEST(SoundPatterns, OrLeftOutByName)
{
    std::vector<Vec2> saw{{0, 0}};
    for (int i = 0; i < 12000; ++i)
        saw.emplace_back(10.0 * i, i % 2 == 0 ? 500 : 600);
    saw.emplace_back(saw.back().x(), 0);
    const Imported imported(drawingWith({lineOf("1", saw, true), rectangleOf("1", {0, 1000}, {300, 200})}));
    EXPECT_EQ(imported.made.patches.size(), 1u);
    EXPECT_TRUE(imported.tells("left out"));
    EXPECT_TRUE(imported.tells("10000"));
}

TEST(SoundPatterns, PiecesFarFromEachOtherAreLaidOut)
{
    const Imported imported(
        drawingWith({rectangleOf("1", {0, 0}, {300, 200}), rectangleOf("1", {9e9, -9e9}, {300, 200}),
                     rectangleOf("1", {3e7, 0}, {300, 200})}));
    EXPECT_EQ(imported.made.patches.size(), 3u);
    imported.design.each<Patch>([](ElementId, const Patch& patch) { EXPECT_LT(patch.position.norm(), 5000); });
}

TEST(SoundPatterns, WhatIsTooLargeIsLeftOutByName)
{
    const Imported imported(
        drawingWith({rectangleOf("1", {0, 0}, {2000, 1500}), rectangleOf("1", {5000, 0}, {3, 2})}), 1000);
    EXPECT_EQ(imported.made.patches.size(), 1u);
    EXPECT_EQ(imported.made.taken, std::vector<std::size_t>{1});
    EXPECT_TRUE(imported.tells("2000 m large"));
}

TEST(SoundPatterns, LargePatternsGetACoarserMesh)
{
    const Imported imported(drawingWith({rectangleOf("1", {0, 0}, {90000, 80000})}));
    EXPECT_GT(imported.design.settings().edgeLength, 12);
    EXPECT_TRUE(imported.tells("edge length"));
}

TEST(SoundPatterns, CrossedOutlinesAreLeftOutAndSayNothingOfTheUnit)
{
    const Drawing drawing = drawingWith(
        {rectangleOf("1", {0, 0}, {60, 40}), lineOf("1", {{0, 1000}, {900, 2000}, {900, 1000}, {0, 2000}}, true)});
    EXPECT_EQ(guessedUnit(drawing), 10) << "nobody sews a pattern of 60 mm, whatever lies beside it";
    const Imported imported(drawing, 10);
    EXPECT_EQ(imported.made.patches.size(), 1u);
    EXPECT_TRUE(imported.tells("crosses itself"));
}

TEST(SoundPatterns, DrawingsInMetres)
{
    EXPECT_EQ(guessedUnit(drawingWith({rectangleOf("1", {0, 0}, {0.6, 0.4})})), 1000);
}

TEST(SoundPatterns, QuantitiesThatCanBeRead)
{
    for (const auto& [words, quantity, pair] : {std::tuple{"2", 2.0, false},
                                                {"1,0", 1.0, false},
                                                {"2,2", 2.0, true},
                                                {"3 , 1", 4.0, false},
                                                {"2.0", 2.0, false},
                                                {"4 pcs", 4.0, false},
                                                {"1000", 1000.0, false}}) {
        const Imported imported(labelled("Quantity: ", words));
        EXPECT_EQ(imported.patch().cutting.quantity, quantity) << words;
        EXPECT_EQ(imported.patch().cutting.pair, pair) << words;
        EXPECT_TRUE(imported.made.notes.empty()) << words;
    }
    EXPECT_EQ(Imported(labelled("", "Cut 2 and 2 mirrored")).patch().cutting.pair, true);
    EXPECT_EQ(Imported(labelled("", "Cut 3 on fold")).patch().cutting.quantity, 3);
    EXPECT_EQ(Imported(labelled("", "Cut 2 of 5 layers")).patch().cutting.quantity, 2);
}

TEST(SoundPatterns, QuantitiesThatCannotAreToldAndDontBecomeOthers)
{
    for (const char* words : {"2.5", "-3", "two", "1/2", "1e3", "0", "2 or 3"}) {
        const Imported imported(labelled("Quantity: ", words));
        EXPECT_EQ(imported.patch().cutting.quantity, 1) << words;
        EXPECT_TRUE(imported.tells(std::string("\"") + words + "\"")) << words;
    }
    const Imported much(labelled("Quantity: ", "99999999999999999999"));
    EXPECT_EQ(much.patch().cutting.quantity, 1000);
    EXPECT_TRUE(much.tells("more than possible"));
    EXPECT_TRUE(Imported(labelled("", "Cut 2.5 of it")).tells("2.5"));
}

TEST(SoundPatterns, WordsThatDoNotBecomePartOfThePatchAreTold)
{
    EXPECT_TRUE(Imported(labelled("Nap: ", "sideways")).tells("sideways"));
    EXPECT_TRUE(Imported(labelled("Nap: ", "one way")).made.notes.empty());
    EXPECT_TRUE(Imported(labelled("Shrinkage: ", "3 % along, 2 % across")).tells("3 % along, 2 % across"));
    EXPECT_EQ(drawnSvg("", "width=\"200mm\" height=\"100mm\" viewBox=\"0 0 200\"").notes.size(), 1u);
    EXPECT_TRUE(drawnSvg("").notes.empty());
    const Drawing far = drawnSvg("", "width=\"300km\" height=\"100mm\" viewBox=\"0 0 200 100\"");
    ASSERT_EQ(far.notes.size(), 1u);
    EXPECT_NE(far.notes[0].english().find("300km"), std::string::npos);
    EXPECT_TRUE(drawnSvg("", "width=\"100%\" height=\"auto\" viewBox=\"0 0 200 100\"").notes.empty());
}

TEST(SoundPatterns, NotMoreElementsThanADesignMayHave)
{
    std::vector<DrawnDot> holes;
    for (int i = 0; i < 100'100; ++i)
        holes.push_back({"13", {1 + 0.9 * (i % 320), 1 + 0.9 * (i / 320)}, 3, 0, {}});
    const Imported imported(
        drawingWith({rectangleOf("1", {0, 0}, {300, 300}), rectangleOf("1", {400, 0}, {300, 300})}, holes));
    EXPECT_TRUE(imported.tells("100000 elements"));
    EXPECT_EQ(imported.made.patches.size(), 1u) << "the other one";
    EXPECT_LE(imported.design.elements().size(), 100'000u);
}

TEST(SoundPatterns, HolesAsWideAsPossible)
{
    DrawnDot hole{"13", {50, 50}, 500, 0, {}};
    const Imported imported(drawingWith({rectangleOf("1", {0, 0}, {300, 200})}, {hole}));
    EXPECT_TRUE(imported.tells("drill holes"));
}

TEST(SoundPatterns, AllowancesThatAreTooWideAreTold)
{
    const auto imported = [](double allowance) {
        const Vec2 off(allowance, allowance);
        return Imported(
            drawingWith({rectangleOf("1", -off, Vec2(800, 800) + 2 * off), rectangleOf("14", {0, 0}, {800, 800})}));
    };
    EXPECT_TRUE(imported(200).made.notes.empty());
    EXPECT_EQ(imported(200).patch().allowance->width, 200);
    EXPECT_TRUE(imported(250).tells("lies 250 mm outside of its sewing line"));
}

TEST(SoundPatterns, OfTwoSewingLinesTheLargerIsTaken)
{
    const Imported imported(
        drawingWith({rectangleOf("1", {0, 0}, {400, 200}), rectangleOf("14", {10, 10}, {200, 180}),
                     rectangleOf("14", {240, 10}, {150, 180})}));
    EXPECT_TRUE(imported.tells("has 2 sewing lines beside each other"));
    EXPECT_NEAR(imported.patch().outline.signedArea(), 200 * 180, 1e-6);
    EXPECT_EQ(imported.patch().allowance->width, 10);
    imported.design.each<EdgeAllowance>([](ElementId, const EdgeAllowance& edge) { ADD_FAILURE() << edge.width; });
    imported.design.each<InternalLine>([](ElementId, const InternalLine&) { ADD_FAILURE() << "outside"; });
}

TEST(SoundPatterns, GapsThatAreClosedAreTold)
{
    const Drawing drawing = drawingWith({lineOf("1", {{0, 0}, {400, 0}, {400, 300}, {0, 300}, {0, 3}})});
    const ImportedPattern closed = patternEdit(Design(), findPieces(drawing, {1, "", 10}));
    ASSERT_EQ(closed.notes.size(), 1u);
    EXPECT_NE(closed.notes[0].english().find("a gap of 3 mm"), std::string::npos) << closed.notes[0].english();
}

TEST(SoundPatterns, TheHistoryCallsOnePieceByItsName)
{
    EXPECT_EQ(Imported(labelled("Quantity: ", "1")).made.edit.verb.english(), "Import the pattern of Seat");
    const Imported two(drawingWith({rectangleOf("1", {0, 0}, {400, 300}), rectangleOf("1", {500, 0}, {400, 300})}));
    EXPECT_EQ(two.made.edit.verb.english(), "Import a pattern of 2 pieces");
}

TEST(SoundPatterns, CutLinesThatAreDrawnOtherwiseAreTold)
{
    const DrawnLine sewn = rectangleOf("14", {0, 0}, {400, 300});
    EXPECT_TRUE(Imported(drawingWith({rectangleOf("1", {-10, -10}, {420, 320}), sewn})).made.notes.empty());
    // One corner alone is cut off, at right angles to where it points.
    const Imported imported(
        drawingWith({lineOf("1", {{-10, -10}, {410, -10}, {410, 300}, {400, 310}, {-10, 310}}, true), sewn}));
    EXPECT_TRUE(imported.tells("differs from that of the file by up to 4.1 mm"));
    EXPECT_EQ(imported.patch().allowance->width, 10);
}

TEST(SoundPatterns, WhatLiesInNoPieceIsCountedByLayer)
{
    const FoundPattern found =
        findPieces(drawingWith({rectangleOf("cut", {0, 0}, {300, 200}), rectangleOf("stitch", {1000, 0}, {50, 50}),
                                rectangleOf("14", {2000, 0}, {50, 50}), lineOf("0", {{3000, 0}, {3100, 0}}),
                                lineOf("notch", {{4000, 0}, {4005, 0}}), lineOf("grain", {{5000, 0}, {5005, 0}}),
                                rectangleOf("9", {0, 0}, {5, 5})},
                               {{"13", {6000, 0}, 0, 0, {}}, {"4", {7000, 0}, 0, 0, {}}, {"5", {1, 1}, 0, 0, {}}}),
                   {});
    EXPECT_EQ(found.outside,
              (std::map<std::string, int>{
                  {"stitch", 1}, {"14", 1}, {"0", 1}, {"notch", 1}, {"grain", 1}, {"13", 1}, {"4", 1}}));
    EXPECT_EQ(found.ignored, (std::map<std::string, int>{{"9", 1}, {"5", 1}}));
}

TEST(SoundPatterns, NamesAreCounted)
{
    Drawing drawing = labelled("", "");
    drawing.parts.push_back(drawing.parts.front());
    drawing.parts.push_back(drawing.parts.front());
    const Imported imported(drawing);
    std::set<std::string> names;
    imported.design.each<Patch>([&](ElementId, const Patch& patch) { names.insert(patch.name); });
    EXPECT_EQ(names, (std::set<std::string>{"Seat", "Seat 2", "Seat 3"}));
}

TEST(SoundPatterns, NotchesOfSeveralStrokes)
{
    // As strokes each of its own: a T, a V with its tip where it is cut, a V the other way round, three slits.
    const auto stroke = [](const Vec2& a, const Vec2& b) { return lineOf("4", {a, b}); };
    const FoundPattern found = findPieces(
        drawingWith({rectangleOf("1", {0, 0}, {400, 300}), stroke({50, 0}, {50, 6}), stroke({47, 6}, {53, 6}),
                     stroke({150, 0}, {147, 5}), stroke({150, 0}, {153, 5}), stroke({247, 0}, {250, 5}),
                     stroke({250, 5}, {253, 0}), stroke({348.5, 0}, {348.5, 5}), stroke({350, 0}, {350, 5}),
                     stroke({351.5, 0}, {351.5, 5})}),
        {});
    ASSERT_EQ(found.pieces.at(0).notches.size(), 4u);
    for (const FoundNotch& notch : found.pieces[0].notches) {
        EXPECT_NEAR(notch.at.y(), 0, 1e-9);
        EXPECT_NEAR(std::fmod(notch.at.x(), 100), 50, 1e-9);
        const auto expected = notch.at.x() < 100   ? NotchShape::Kind::T
                              : notch.at.x() < 300 ? NotchShape::Kind::V
                                                   : NotchShape::Kind::Slit;
        EXPECT_EQ(notch.shape.kind, expected) << notch.at.x();
        EXPECT_EQ(notch.twice, expected == NotchShape::Kind::Slit);
        EXPECT_NEAR(notch.inwards->y(), 1, 1e-9);
    }
    EXPECT_TRUE(found.ignored.empty());
}

} // namespace bolster
