#include "SeamProposals.h"

#include "ArcLength.h"
#include "DartEdits.h"
#include "DesignJson.h"
#include "ImportedDesigns.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster {

namespace {

bool sameStretch(const Design& design, const Stretch& a, const Stretch& b)
{
    if (a.patch != b.patch)
        return false;
    const BSpline2& outline = design.find<Patch>(a.patch)->outline;
    const auto at = [&](double t) { return outline.at(outline.wrapped(t)); };
    return (at(a.from) - at(b.from)).norm() < 1 && (at(a.to) - at(b.to)).norm() < 1;
}

bool isSeamOf(const Design& design, const SeamProposal& proposal)
{
    bool found = false;
    design.each<Seam>([&](ElementId, const Seam& seam) {
        const bool forwards = sameStretch(design, seam.a, proposal.a) && sameStretch(design, seam.b, proposal.b);
        const bool backwards = sameStretch(design, seam.a, proposal.b) && sameStretch(design, seam.b, proposal.a);
        found = found || ((forwards || backwards) && seam.reversed == proposal.reversed);
    });
    return found;
}

template <class T>
Design without(const Design& design)
{
    Edit edit;
    for (const auto& [id, element] : design.elements())
        if (std::holds_alternative<T>(*element))
            edit.changes.push_back({id, element, nullptr});
    return design.with(edit);
}

} // namespace

class Proposals : public testing::TestWithParam<const char*> {};

TEST_P(Proposals, AreMostlyTheSeamsThatThereWere)
{
    const Design design = test::sampleDesign(GetParam());
    int seams = 0;
    design.each<Seam>([&](ElementId, const Seam&) { ++seams; });
    for (const bool fixed : {true, false}) {
        Design bare = without<Seam>(without<Notch>(design));
        if (!fixed)
            bare = without<FixationSeam>(bare);
        const std::vector<SeamProposal> proposals = proposeSeams(bare);
        int right = 0;
        for (const SeamProposal& proposal : proposals) {
            right += isSeamOf(design, proposal);
        }
        RecordProperty(fixed ? "right_with_fixations" : "right", right);
        RecordProperty(fixed ? "proposed_with_fixations" : "proposed", static_cast<int>(proposals.size()));
        EXPECT_GE(right, 0.9 * static_cast<double>(proposals.size())) << fixed;
        EXPECT_GE(right, 0.85 * seams) << fixed;
    }
}

TEST(SeamProposals, BecomeSeams)
{
    const Design design = test::sampleDesign("car-seat");
    const Design bare = without<Seam>(design);
    const Design sewn = bare.with(sewProposals(bare, proposeSeams(bare)));
    int seams = 0;
    sewn.each<Seam>([&](ElementId, const Seam&) { ++seams; });
    EXPECT_EQ(seams, 28);
    EXPECT_TRUE(proposeSeams(sewn).empty()) << "nothing is left over that belongs together";
}

namespace {

Patch panel(const char* name, double width, double height, const Vec2& position)
{
    Patch patch;
    patch.name = name;
    patch.outline = BSpline2(1, true, {{0, 0}, {width, 0}, {width, height}, {0, height}});
    patch.position = position;
    return patch;
}

/// A box: two panels, and a strip around them.
Design boxCushion()
{
    const Patch patches[] = {panel("Top", 520, 400, {0, 0}), panel("Bottom", 520, 400, {600, 0}),
                             panel("Strip", 1840, 80, {0, -200})};
    Edit edit;
    int id = 0;
    for (const Patch& patch : patches)
        edit.changes.push_back({ElementId(++id), nullptr, makeElement(patch)});
    return Design().with(edit);
}

/// How many proposals sew the strip to a panel, and how long they are together.
std::pair<int, double> alongStrip(const std::vector<SeamProposal>& proposals, ElementId panel)
{
    std::pair<int, double> found{0, 0};
    for (const SeamProposal& proposal : proposals)
        for (const auto& [a, b] : {std::pair(proposal.a, proposal.b), std::pair(proposal.b, proposal.a)})
            if (a.patch == panel && b.patch == ElementId(3)) {
                ++found.first;
                found.second += proposal.lengthA;
            }
    return found;
}

} // namespace

TEST(SeamProposals, DivideTheStripAroundACushion)
{
    const Design box = boxCushion();
    const std::vector<SeamProposal> proposals = proposeSeams(box);
    for (const int panel : {1, 2}) {
        const auto [count, length] = alongStrip(proposals, ElementId(panel));
        EXPECT_EQ(count, 4) << panel;
        EXPECT_NEAR(length, 1840, 1) << panel;
    }
    EXPECT_EQ(proposals.size(), 9u) << "and the strip's ends";
    const Design sewn = box.with(sewProposals(box, proposals));
    int seams = 0;
    sewn.each<Seam>([&](ElementId, const Seam&) { ++seams; });
    EXPECT_EQ(seams, 9) << "none overlaps another one";
}

TEST(SeamProposals, DivideAStripAtItsNotches)
{
    // The strip is as long as another piece's edge, but its notches are where the panel's corners come.
    Patch seat = panel("Seat", 520, 400, {0, 0});
    seat.outline = BSpline2(1, true, {{0, 0}, {520, 0}, {500, 399.5}, {20, 399.5}}); // wider in front
    Edit edit;
    edit.changes = {{ElementId(1), nullptr, makeElement(seat)},
                    {ElementId(2), nullptr, makeElement(panel("Skirt", 1320, 300, {700, 0}))},
                    {ElementId(3), nullptr, makeElement(panel("Strip", 1320, 80, {0, -200}))}};
    int id = 3;
    for (const double at : {400.0 / 1320, 920.0 / 1320}) {
        Notch notch;
        notch.place = {ElementId(3), 2 + at}; // its upper edge, which runs from right to left
        edit.changes.push_back({ElementId(++id), nullptr, makeElement(notch)});
    }
    const auto [count, length] = alongStrip(proposeSeams(Design().with(edit)), ElementId(1));
    EXPECT_EQ(count, 3);
    EXPECT_NEAR(length, 1320, 1);
}

TEST(SeamProposals, DivideEdgesAtNotchesWhereNothingFitsThemWhole)
{
    // A disc without any corner, and two strips around it, each along a half.
    Patch disc;
    disc.name = "Disc";
    std::vector<Vec2> around;
    for (int i = 0; i < 24; ++i)
        around.emplace_back(100 * std::cos(i * std::numbers::pi / 12), 100 * std::sin(i * std::numbers::pi / 12));
    disc.outline = BSpline2(3, true, around);
    const ArcLength2 length(disc.outline);
    const double half = length.total() / 2, start = 0.6 * length.total();
    const auto place = [&](double along) {
        return disc.outline.wrapped(length.parameterAt(std::fmod(start + along, length.total())));
    };
    const auto strip = [&](const char* name, double above) { // with a hem
        Patch patch = panel(name, half, 57, {300, 0});
        patch.outline = BSpline2(1, true, {{0, 0}, {half, 0}, {half, 57}, {half / 2, above}, {0, 57}});
        return patch;
    };
    Edit edit;
    edit.changes = {{ElementId(1), nullptr, makeElement(disc)},
                    {ElementId(2), nullptr, makeElement(strip("Front strip", 80))},
                    {ElementId(3), nullptr, makeElement(strip("Rear strip", 140))}};
    int id = 3;
    const auto notch = [&](int patch, double at) {
        edit.changes.push_back({ElementId(++id), nullptr, makeElement(Notch{{ElementId(patch), at}, {}})});
    };
    for (const double share : {0.0, 0.3, 1.0, 1.6})
        notch(1, place(share * half));
    notch(2, 0.7);
    notch(3, 0.4);
    double sewn = 0;
    for (const SeamProposal& proposal : proposeSeams(Design().with(edit))) {
        if (proposal.a.patch != ElementId(1) && proposal.b.patch != ElementId(1))
            continue;
        EXPECT_NEAR(proposal.lengthA, half, 0.1);
        EXPECT_NEAR((proposal.a.patch == ElementId(1) ? proposal.b : proposal.a).from, 0, 1e-9)
            << "the strip's edge that has the notch";
        sewn += proposal.lengthA;
    }
    EXPECT_NEAR(sewn, 2 * half, 0.2);
}

TEST(SeamProposals, EndWhenAskedTo)
{
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(proposeSeams(without<Seam>(test::sampleDesign("car-seat")), stop.get_token()).empty());
}

INSTANTIATE_TEST_SUITE_P(Samples, Proposals, testing::Values("car-seat", "armchair", "pillow"));

namespace {

/// Two panels of which the edges at x = 200 and x = 0 belong together, the first one with a dart in it, 20 mm wide.
Design dartedPanels(bool backwards = false)
{
    Patch darted = panel("Front", 200, 100, {0, 0});
    const Patch plain = panel("Back", 150, 80, {300, 0});
    darted.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 30}, {140, 40}, {200, 50}, {200, 100}, {0, 100}});
    if (backwards)
        darted.outline = darted.outline.reversed();
    return Design().with(
        {{}, {{ElementId(1), nullptr, makeElement(darted)}, {ElementId(2), nullptr, makeElement(plain)}}});
}

} // namespace

TEST(SeamProposals, LegsOfDartsAreAmongTheMostCertain)
{
    for (const bool backwards : {false, true}) {
        const Design design = dartedPanels(backwards);
        const std::vector<SeamProposal> proposals = proposeSeams(design);
        ASSERT_FALSE(proposals.empty());
        const SeamProposal& first = proposals.front();
        EXPECT_EQ(sewProposals(design, {first}).verb.english(), "Sew a proposed seam");
        EXPECT_TRUE(first.dart);
        EXPECT_GT(first.certainty, 0.9);
        EXPECT_TRUE(first.reversed);
        EXPECT_NEAR(first.lengthA, std::hypot(60, 10), 1e-6);
        const Design sewn = design.with(sewProposals(design, {first}));
        int darts = 0;
        sewn.each<Seam>([&](ElementId id, const Seam& seam) {
            const auto dart = edits::dartOf(sewn, id);
            darts += dart && dart->tip.isApprox(Vec2(140, 40), 1e-9) && seam.continuity == Continuity::C1;
        });
        EXPECT_EQ(darts, 1) << "it is one as if it had been drawn";
    }
}

TEST(SeamProposals, AnEdgeRunsPastADart)
{
    Design design = dartedPanels();
    design = design.with({{}, {{ElementId(3), nullptr, makeElement(Notch{{ElementId(2), 3 + 50.0 / 80}, {}})}}});
    std::vector<double> lengths;
    for (const SeamProposal& proposal : proposeSeams(design))
        if (proposal.a.patch != proposal.b.patch)
            lengths.push_back(proposal.lengthA);
    std::ranges::sort(lengths);
    ASSERT_GE(lengths.size(), 2u);
    EXPECT_NEAR(lengths[0], 30, 0.5) << "both parts beside the dart";
    EXPECT_NEAR(lengths[1], 50, 0.5);
}

TEST(SeamProposals, WedgesThatAreNoDartsAreLeftAlone)
{
    const auto hasDart = [](const Design& design) {
        return std::ranges::any_of(proposeSeams(design), &SeamProposal::dart);
    };
    // One leg is longer than the other one.
    Design uneven = dartedPanels();
    Patch patch = *uneven.find<Patch>(ElementId(1));
    patch.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 30}, {140, 45}, {200, 50}, {200, 100}, {0, 100}});
    uneven = uneven.with({{}, {{ElementId(1), nullptr, makeElement(patch)}}});
    EXPECT_FALSE(hasDart(uneven));
    // The inner corner of an L, both of whose edges are of one length.
    patch.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 40}, {140, 40}, {140, 100}, {0, 100}});
    const Design corner = uneven.with({{}, {{ElementId(1), nullptr, makeElement(patch)}}});
    EXPECT_FALSE(hasDart(corner));
}

TEST(SeamProposals, DartsMayBeCurved)
{
    for (const bool mirrored : {true, false}) {
        Patch patch = panel("Front", 200, 100, {0, 0});
        const double bend = mirrored ? 44 : 37; // the other leg is its mirror image, or bends along with it
        patch.outline = BSpline2::withCorners(
            {{0, 0},    {66, 0},    {133, 0},   {200, 0},    {200, 10},   {200, 20}, {200, 30},
             {180, 36}, {160, 36},  {140, 40},  {160, bend}, {180, bend}, {200, 50}, {200, 66},
             {200, 83}, {200, 100}, {133, 100}, {66, 100},   {0, 100},    {0, 66},   {0, 33}},
            {0, 3, 6, 9, 12, 15, 18});
        const Design design = Design().with({{}, {{ElementId(1), nullptr, makeElement(patch)}}});
        EXPECT_EQ(std::ranges::any_of(proposeSeams(design), &SeamProposal::dart), mirrored);
    }
}

} // namespace bolster
