#include "Message.h"
#include "Problem.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

TEST(Message, FillsInItsArguments)
{
    EXPECT_EQ((Message{"Move %2 points of %1", {"Seat", "3"}}.english()), "Move 3 points of Seat");
    EXPECT_EQ((Message{"%1%1 %3", {"a", "b"}}.english()), "aa %3");
    EXPECT_EQ((Message{"100 % of %", {}}.english()), "100 % of %");
    EXPECT_EQ(filledIn("%10 %1", {"1", "2", "3", "4", "5", "6", "7", "8", "9", "ten"}), "ten 1");
}

TEST(Message, DoesNotExpandWhatStandsInArguments)
{
    EXPECT_EQ((Message{"Rename %1 to %2", {"%2", "%1 %%"}}.english()), "Rename %2 to %1 %%");
}

TEST(Message, WritesNumbersForPeople)
{
    EXPECT_EQ(numberText(12), "12");
    EXPECT_EQ(numberText(12.34567), "12.35");
    EXPECT_EQ(numberText(0.000123456), "0.0001235");
    EXPECT_EQ(numberText(1e7), "10000000");
    EXPECT_EQ(numberText(123456.7), "123457");
    EXPECT_EQ(numberText(-0.5), "-0.5");
    EXPECT_EQ(numberText(0), "0");
    EXPECT_EQ(numberText(-0.0), "0");
    EXPECT_EQ(numberText(9.99999), "10");
    EXPECT_EQ(numberText(1e300), "1.000e+300");
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "NaN");
}

TEST(Problem, NamesPlaceAndField)
{
    const Problem problem{
        ElementId{2}, "patch 2 \"Seat\"", "outline.points", {"is %1", {"wrong"}}, Severity::Error};
    EXPECT_EQ(problem.english(), "patch 2 \"Seat\", outline.points: is wrong");
    EXPECT_EQ((Problem{settingsId, "", "", {"broken"}, Severity::Error}.english()), "broken");
    EXPECT_TRUE(hasErrors({problem}));
    EXPECT_FALSE(hasErrors({}));
    EXPECT_FALSE(hasErrors({{ElementId{2}, "", "", {}, Severity::Warning}}));
}

} // namespace
} // namespace bolster
