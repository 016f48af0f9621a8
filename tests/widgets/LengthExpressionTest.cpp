#include "LengthExpression.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster {
namespace {

const QLocale english(QLocale::English, QLocale::UnitedStates);
const QLocale german(QLocale::German, QLocale::Germany);

double mm(const char* text, const QLocale& locale = english)
{
    return parseLength(QString::fromUtf8(text), locale).value_or(std::nan(""));
}

TEST(LengthExpression, TakesUnits)
{
    EXPECT_DOUBLE_EQ(mm("500"), 500);
    EXPECT_DOUBLE_EQ(mm(" 500 mm "), 500);
    EXPECT_DOUBLE_EQ(mm("2.5cm"), 25);
    EXPECT_DOUBLE_EQ(mm("0.5 m"), 500);
    EXPECT_DOUBLE_EQ(mm("2 in"), 50.8);
    EXPECT_DOUBLE_EQ(mm("2 Inch"), 50.8);
    EXPECT_DOUBLE_EQ(mm("2\""), 50.8);
    EXPECT_DOUBLE_EQ(mm("1 ft"), 304.8);
}

TEST(LengthExpression, Calculates)
{
    EXPECT_DOUBLE_EQ(mm("3*25 mm"), 75);
    EXPECT_DOUBLE_EQ(mm("1/2 in"), 12.7);
    EXPECT_DOUBLE_EQ(mm("(10+2)/3 cm"), 40);
    EXPECT_DOUBLE_EQ(mm("1 in + 2 cm - 5"), 40.4);
    EXPECT_DOUBLE_EQ(mm("2 cm * 3 / 4"), 15);
    EXPECT_DOUBLE_EQ(mm("-3 * -(2 + 3)"), 15);
    EXPECT_DOUBLE_EQ(mm("100 - 10 - 1"), 89) << "from the left";
    EXPECT_DOUBLE_EQ(mm("3 \u00d7 25 mm"), 75);
    EXPECT_DOUBLE_EQ(mm("2*(1 in)"), 50.8);
    EXPECT_DOUBLE_EQ(mm("1e3"), 1000);
    EXPECT_DOUBLE_EQ(mm("2.5E-1 cm"), 2.5);
    EXPECT_FALSE(parseLength(QStringLiteral("e3"), english));
    EXPECT_FALSE(parseLength(QStringLiteral("1e"), english));
    EXPECT_FALSE(parseLength(QStringLiteral("1e999"), english));
}

TEST(LengthExpression, FollowsTheLanguagesNumbers)
{
    EXPECT_DOUBLE_EQ(mm("2,5 cm", german), 25);
    EXPECT_DOUBLE_EQ(mm("2.5 cm", german), 25);
    EXPECT_DOUBLE_EQ(mm("1.500,5", german), 1500.5);
    EXPECT_DOUBLE_EQ(mm("1.500", german), 1500) << "as the language groups digits";
    EXPECT_DOUBLE_EQ(mm("1,500"), 1500);
    EXPECT_DOUBLE_EQ(mm("0,500"), 0.5) << "no group begins with a zero";
    EXPECT_DOUBLE_EQ(mm("12,5"), 12.5);
    EXPECT_DOUBLE_EQ(mm("1,234,567.5"), 1234567.5);
}

TEST(LengthExpression, RefusesWhatIsNoLength)
{
    for (const char* text : {"", " ", "mm", "abc", "3*", "*3", "(3", "3)", "1 2", "2 mm * 3 mm", "1/(2 mm)", "1/0",
                             "5 kg", "1.2.3", "3 mm mm", "--", "1e400*", "12,34,5"})
        EXPECT_FALSE(parseLength(QString::fromUtf8(text), english)) << text;
    EXPECT_FALSE(parseLength(QString(5000, u'(') + u'1', english)) << "deep nesting";
    EXPECT_FALSE(parseLength(QString(5000, u'-') + u'1', english));
}

TEST(LengthExpression, NumbersHaveNoUnits)
{
    EXPECT_DOUBLE_EQ(parseNumber(QStringLiteral("180/8"), english).value(), 22.5);
    EXPECT_FALSE(parseNumber(QStringLiteral("5 mm"), english));
}

} // namespace
} // namespace bolster
