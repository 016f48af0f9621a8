#include "FabricColors.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

TEST(FabricColorsTest, SecondColoursAreDerivedUnlessGiven)
{
    Fabric fabric;
    fabric.look.kind = FabricLook::Kind::GrainedLeather;
    fabric.look.secondColor = "#402010";
    EXPECT_EQ(secondColorShown(fabric), "#402010");
    fabric.color = "#808080";
    fabric.look = usualLook(FabricLook::Kind::GrainedLeather);
    EXPECT_LT(secondColorShown(fabric), fabric.color) << "creases are darker";
    fabric.look = usualLook(FabricLook::Kind::Checker);
    EXPECT_GT(secondColorShown(fabric), fabric.color);
}

} // namespace
} // namespace bolster
