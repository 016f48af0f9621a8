#include "CutNotches.h"

#include "Panels.h"

#include <gtest/gtest.h>

namespace bolster {

namespace {

using namespace test;

AutomaticNotches none()
{
    AutomaticNotches order;
    order.ends = false;
    order.telling = false;
    return order;
}

std::vector<double> at(const std::map<ElementId, std::vector<NotchPlace>>& places, ElementId patch)
{
    std::vector<double> result;
    if (const auto found = places.find(patch); found != places.end())
        for (const NotchPlace& place : found->second)
            result.push_back(place.at);
    return result;
}

} // namespace

TEST(CutNotches, AlongASeamMeetWhenItIsSewn)
{
    AutomaticNotches order = none();
    order.spacing = 30;
    const auto places = notchPlaces(twoPanels(), order);
    ASSERT_EQ(at(places, left).size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
        const double share = 0.25 * static_cast<double>(k + 1);
        EXPECT_NEAR(at(places, left)[k], 1 + share, 1e-9);
        EXPECT_NEAR(at(places, right)[k], 3 + share, 1e-9);
    }
    for (const NotchPlace& place : places.at(left)) {
        const auto partner = std::ranges::find(places.at(right), place.fraction, &NotchPlace::fraction);
        ASSERT_NE(partner, places.at(right).end());
        EXPECT_NEAR(place.at - 1, 1 - (partner->at - 3), 1e-9) << "the second side is walked backwards";
        EXPECT_EQ(partner->seam, between);
    }
}

TEST(CutNotches, StandALittleFartherApartThanSaidRatherThanOneMore)
{
    AutomaticNotches order = none();
    order.spacing = 24.9; // on 100 mm: 0.4 % less than a quarter
    EXPECT_EQ(at(notchPlaces(twoPanels(), order), left).size(), 3u);
    order.spacing = 24.5; // 2 % less
    EXPECT_EQ(at(notchPlaces(twoPanels(), order), left).size(), 4u);
}

TEST(CutNotches, FollowTheSeamsOwnMatch)
{
    // The right edge bulges: equal parameters are not equal lengths.
    Design design = twoPanels();
    Patch bulged = *design.find<Patch>(left);
    bulged.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {260, 10}, {200, 100}, {0, 100}});
    design = with(design, left, bulged);
    Seam seam = *design.find<Seam>(between);
    seam.a = {left, 1, 3};
    design = with(design, between, seam);
    AutomaticNotches order = none();
    order.spacing = 100; // two parts
    const double length = std::hypot(60, 10), rest = std::hypot(60, 90);
    const double byLength = notchPlaces(design, order).at(left).front().at;
    EXPECT_NEAR(byLength, 2 + ((length + rest) / 2 - length) / rest, 1e-9);
    seam.match = Match::Parameter;
    EXPECT_DOUBLE_EQ(notchPlaces(with(design, between, seam), order).at(left).front().at, 2);
}

TEST(CutNotches, StandWhereASeamStopsInsideAnEdge)
{
    AutomaticNotches order = none();
    order.ends = true;
    EXPECT_TRUE(at(notchPlaces(twoPanels(), order), left).empty()) << "this one ends at corners";
    Design design = twoPanels();
    Seam seam = *design.find<Seam>(between);
    seam.a.to = 1.5;
    seam.b.from = 3.5;
    const auto places = notchPlaces(with(design, between, seam), order);
    EXPECT_EQ(at(places, left), (std::vector{1.5}));
    EXPECT_EQ(at(places, right), (std::vector{3.5}));
}

TEST(CutNotches, StandAtCornersThatNobodySees)
{
    AutomaticNotches order = none();
    order.ends = true;
    for (const double outwards : {10.0, 90.0}) {
        Design design = twoPanels();
        Patch patch = *design.find<Patch>(left);
        // The seam ends at its third corner, where the outline hardly turns, or by much.
        patch.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 100}, {200 - outwards, 200}, {0, 200}});
        design = with(design, left, patch);
        EXPECT_EQ(at(notchPlaces(design, order), left).size(), outwards < 50 ? 1u : 0u) << outwards;
    }
}

TEST(CutNotches, OfFancySeamsStandWhereTheyMeetTheOutline)
{
    FancySeam fancy;
    fancy.patch = left;
    fancy.curve = BSpline2(1, false, {{200, 30}, {100, 30}});
    AutomaticNotches order = none();
    order.ends = true;
    const auto places = notchPlaces(with(twoPanels(), ElementId{9}, fancy), order);
    ASSERT_EQ(at(places, left).size(), 1u);
    EXPECT_NEAR(at(places, left).front(), 1.3, 1e-6);
    ASSERT_EQ(at(places, right).size(), 1u) << "it is on a seam, so it meets something";
    EXPECT_NEAR(at(places, right).front(), 3.7, 1e-6);
}

TEST(CutNotches, ByHandHaveAPartnerOnTheOtherSide)
{
    Notch notch;
    notch.place = {right, 3.2};
    notch.shape.kind = NotchShape::Kind::V;
    notch.twice = true;
    const auto places = notchPlaces(with(twoPanels(), ElementId{9}, notch), none());
    ASSERT_EQ(at(places, left).size(), 1u);
    EXPECT_NEAR(at(places, left).front(), 1.8, 1e-9);
    EXPECT_EQ(places.at(left).front().shape.kind, NotchShape::Kind::V);
    EXPECT_TRUE(places.at(left).front().twice);

    notch.place = {right, 0.5};
    const auto alone = notchPlaces(with(twoPanels(), ElementId{9}, notch), none());
    EXPECT_TRUE(at(alone, left).empty());
    EXPECT_EQ(at(alone, right), (std::vector{0.5}));
}

TEST(CutNotches, TellWhichWayRoundAndWhichSeam)
{
    AutomaticNotches order = none();
    order.telling = true;
    const auto places = notchPlaces(twoPanels(), order);
    ASSERT_EQ(at(places, left).size(), 1u) << "a rectangle looks the same turned round";
    EXPECT_NEAR(places.at(left).front().fraction, 0.4, 1e-9) << "off the middle";

    // A second seam of the same length: two notches side by side.
    Seam second;
    second.a = {left, 3, 4};
    second.b = {right, 1, 2};
    const auto both = notchPlaces(with(twoPanels(), ElementId{5}, second), order);
    ASSERT_EQ(both.at(left).size(), 2u);
    EXPECT_NE(both.at(left)[0].twice, both.at(left)[1].twice);
}

TEST(CutNotches, AreNotTwiceAtOnePlace)
{
    Notch notch;
    notch.place = {left, 1.5};
    AutomaticNotches order = none();
    order.spacing = 50;
    const auto places = notchPlaces(with(twoPanels(), ElementId{9}, notch), order);
    ASSERT_EQ(at(places, left).size(), 1u);
    EXPECT_EQ(places.at(left).front().element, ElementId{9}) << "the one that somebody placed";
}

} // namespace bolster
