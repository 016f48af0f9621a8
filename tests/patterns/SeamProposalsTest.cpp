#include "SeamProposals.h"

#include "DesignJson.h"
#include "ImportedDesigns.h"

#include <gtest/gtest.h>

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

TEST(SeamProposals, EndWhenAskedTo)
{
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(proposeSeams(without<Seam>(test::sampleDesign("car-seat")), stop.get_token()).empty());
}

INSTANTIATE_TEST_SUITE_P(Samples, Proposals, testing::Values("car-seat", "armchair", "pillow"));

} // namespace bolster
