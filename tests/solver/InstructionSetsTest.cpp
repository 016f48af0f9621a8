// What every instruction set computes, not only the best one that this machine has.
#include "PackedKernels.h"
#include "TestDesigns.h"

#include <hwy/targets.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace bolster::test {
namespace {

class InstructionSets : public testing::Test {
protected:
    static void use(std::int64_t targets)
    {
        hwy::SetSupportedTargetsForTest(targets);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }

    void TearDown() override { use(0); } // what the machine has
};

TEST_F(InstructionSets, AgreeOnSurfaces)
{
    const std::int64_t all = hwy::SupportedTargets();
    const SurfaceMeshPtr best = solved(tube(300, 200, 12, 8), 1e-7).surface;
    std::set<std::string> tried;
    for (std::int64_t left = all; left != 0; left &= left - 1) {
        use(left & -left);
        tried.insert(packedInstructions());
        const SolveResult result = solved(tube(300, 200, 12, 8), 1e-7);
        double apart = 0; // mm
        for (std::size_t v = 0; v < best->positions.size(); ++v)
            apart = std::max(apart, (result.surface->positions[v] - best->positions[v]).norm());
        EXPECT_LT(apart, 0.01) << packedInstructions();
    }
    EXPECT_GE(tried.size(), 2U) << "at least one beside the fallback";
}

} // namespace
} // namespace bolster::test
