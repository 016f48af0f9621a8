#include "DesignHash.h"
#include "EditCodec.h"
#include "TestPaths.h"
#include "TestProject.h"

#include <bit>
#include <limits>

namespace bolster::test {
namespace {

using Known = StoredEdits::Known;

/// Through the bytes and back, in both directions.
void expectRoundTrip(const Design& from, const Edit& edit)
{
    const Design to = from.with(edit);
    const auto changes = decodeChanges(encodeChanges(fieldChanges(edit)));
    ASSERT_TRUE(changes);
    EXPECT_EQ(unpackChanges(packChanges(*changes)), changes);
    EXPECT_EQ(unpackChanges(encodeChanges(*changes)), changes);
    const auto forward = editOf(*changes, from, Known::Parent);
    const auto backward = editOf(*changes, to, Known::Child);
    ASSERT_TRUE(forward && backward);
    EXPECT_EQ(writeDesign(from.with(*forward)), writeDesign(to));
    EXPECT_EQ(writeDesign(to.with(backward->inverse())), writeDesign(from));
    EXPECT_TRUE(refusal(edit).empty());
}

TEST(EditCodec, EveryKindOfElementComesBackToTheLastBit)
{
    for (const char* sample : {"box-cushion", "car-seat", "armchair"}) {
        const QString name(sample);
        const ReadDesign read = readDesign(
            readWholeFile(QString::fromStdString(test::samplesFolder()) + "/" + name + "/" + name + ".json",
                          10'000'000)
                .bytes);
        ASSERT_TRUE(read.readable) << sample;
        expectRoundTrip(Design(), editBetween(Design(), read.design, {}));
        const auto again = decodeDesign(encodeDesign(read.design));
        ASSERT_TRUE(again);
        EXPECT_EQ(writeDesign(again->design), writeDesign(read.design));
    }
    expectRoundTrip(Design(), editBetween(Design(), smallDesign(), {}));
}

TEST(EditCodec, EditsComeBackInBothDirections)
{
    Hands hands(1);
    Design design = smallDesign();
    for (int i = 0; i < 500; ++i) {
        const Edit edit = editBetween(design, design.with(hands.edit(design)), {});
        expectRoundTrip(design, edit);
        design = design.with(edit);
    }
}

TEST(EditCodec, OnlyTheFieldsThatChangedAreStored)
{
    const Design design = smallDesign();
    const FieldChanges renamed = fieldChanges(edits::renameElement(design, ElementId{2}, "Sitz"));
    const FieldChanges wanted = {{ElementId{2}, "name", "\"Seat\"", "\"Sitz\""}};
    EXPECT_EQ(renamed, wanted);
}

TEST(EditCodec, KeepsTheSignOfZeroAndEveryBitOfANumber)
{
    const Design design = smallDesign();
    for (const double number : {-0.0, 5e-324, 0.1 + 0.2, 9999999.999999998, -1e-310}) {
        FixationCurve curve = *design.find<FixationCurve>(ElementId{4});
        curve.curve = BSpline3(1, false, {{number, 0, 0}, {1, 2, 3}});
        const Edit edit{{}, {{ElementId{4}, design.element(ElementId{4}), makeElement(curve)}}};
        const auto changes = decodeChanges(encodeChanges(fieldChanges(edit)));
        const auto again = editOf(*changes, design, Known::Parent);
        const double back = design.with(*again).find<FixationCurve>(ElementId{4})->curve.points()[0].x();
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(number)) << number;
    }
}

TEST(EditCodec, RefusesWhatWouldNotComeBack)
{
    const Design design = smallDesign();
    for (const double number :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Patch patch = *design.find<Patch>(ElementId{2});
        patch.pressure = number;
        const Message why = refusal({{}, {{ElementId{2}, design.element(ElementId{2}), makeElement(patch)}}});
        EXPECT_TRUE(why.english().starts_with("patch 2 \"Seat\" cannot be stored")) << why.english();
    }
    EXPECT_FALSE(refusal(edits::renameElement(design, ElementId{2}, "\xff")).empty());
    EXPECT_FALSE(refusal({{}, {{settingsId, nullptr, makeElement(Settings{NAN})}}}).empty());
}

TEST(EditCodec, RefusesAnythingElse)
{
    const std::string good = encodeChanges(fieldChanges(editBetween(Design(), smallDesign(), {})));
    ASSERT_TRUE(decodeChanges(good));
    for (std::size_t length = 0; length < good.size(); ++length)
        EXPECT_FALSE(decodeChanges(std::string_view(good).substr(0, length))) << length;
    EXPECT_FALSE(decodeChanges(good + "x"));
    // Texts and lists that claim more than there is, lists of unknown length, deep nesting, other things.
    for (const std::string_view bytes :
         {std::string_view("\x81\x84\x01\x7b\x7f\xff\xff\xff\xff\xff\xff\xff", 12),
          std::string_view("\x9b\x7f\xff\xff\xff\xff\xff\xff\xff", 9), std::string_view("\x9f\xff"),
          std::string_view("\x81\x83\x01\x61\x61\xf6"), std::string_view("\x81\x84\x01\x7f\x61\x61\xff\xf6\xf6"),
          std::string_view("\x81\x84\x20\x61\x61\xf6\xf6"), std::string_view("\x81\x84\x01\x01\xf6\xf6")})
        EXPECT_FALSE(decodeChanges(bytes));
    EXPECT_FALSE(decodeChanges(std::string(100'000, '\x81')));
    EXPECT_TRUE(decodeChanges(std::string_view("\x80")));
}

TEST(EditCodec, RefusesWhatIsOutOfOrderOrChangesNothingOrIsTooMuch)
{
    const std::string_view one("\x84\x01\x61\x61\xf6\x61\x31", 7), two("\x84\x02\x61\x61\xf6\x61\x31", 7);
    const auto listed = [](std::initializer_list<std::string_view> changes) {
        std::string bytes(1, static_cast<char>(0x80 + changes.size()));
        for (const std::string_view change : changes)
            bytes += change;
        return bytes;
    };
    EXPECT_TRUE(decodeChanges(listed({one, two})));
    EXPECT_FALSE(decodeChanges(listed({two, one})));
    EXPECT_FALSE(decodeChanges(listed({one, one})));
    EXPECT_FALSE(decodeChanges(listed({std::string_view("\x84\x01\x61\x61\xf6\xf6", 6)})));
    EXPECT_FALSE(decodeTexts("\x98\xc8" + std::string(200, '\x60'))) << "no verb has 200 arguments";

    const Design large =
        Design().with({{}, {{ElementId{1}, nullptr, makeElement(Quarantined{std::string(70'000'000, 'x'), {}})}}});
    const Message why = refusal(editBetween(Design(), large, {}));
    EXPECT_NE(why.english().find("more at once than can be stored"), std::string::npos) << why.english();
    EXPECT_EQ(encodeDesign(large), "");
}

TEST(EditCodec, TextsMayBeEmptyAndLong)
{
    for (const std::vector<std::string>& texts :
         {std::vector<std::string>{}, {""}, {"", "a", ""}, {std::string(100'000, 'x'), "\n\"ß"}})
        EXPECT_EQ(decodeTexts(encodeTexts(texts)), texts);
}

TEST(DesignHash, FollowsAsIfItWereComputedAnew)
{
    Hands hands(2);
    DesignHash hash;
    std::vector<Design> designs = {smallDesign()};
    for (int i = 0; i < 300; ++i) {
        designs.push_back(designs.back().with(hands.edit(designs.back())));
        const Design& any = designs[static_cast<std::size_t>(hands.pick(static_cast<int>(designs.size())))];
        EXPECT_EQ(hash.follow(any), hashOf(any));
        EXPECT_EQ(hashOf(any) == hashOf(designs.front()), writeDesign(any) == writeDesign(designs.front()));
    }
    EXPECT_NE(hashOf(Design()), hashOf(smallDesign()));
}

} // namespace
} // namespace bolster::test
