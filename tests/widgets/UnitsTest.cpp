// Lengths as the user likes them: shown, typed, and back.
#include "LengthExpression.h"
#include "NumberBox.h"
#include "PatternGrid.h"
#include "Translated.h"

#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bolster {
namespace {

/// For a test; as at first afterwards.
class StyledNumbers {
public:
    explicit StyledNumbers(const NumberStyle& style) { NumberStyles::instance().set(style); }
    StyledNumbers(const StyledNumbers&) = delete;
    StyledNumbers& operator=(const StyledNumbers&) = delete;
    ~StyledNumbers() { NumberStyles::instance().set({}); }
};

constexpr NumberStyle inInches(int fraction)
{
    return {LengthUnit::Inches, fraction, DecimalSign::Point};
}

double typedLength(const char* text)
{
    return parseLength(QString::fromUtf8(text)).value_or(std::nan(""));
}

/// What a box has after somebody has typed over all of it.
double typedOver(NumberBox& box, const char* text)
{
    box.selectAll();
    QTest::keyClicks(&box, QString::fromUtf8(text));
    QTest::keyClick(&box, Qt::Key_Return);
    return box.value();
}

TEST(Translated, NamesThatTurnTheDirectionDoNotTurnTheSentence)
{
    EXPECT_EQ(isolated(QStringLiteral("Seat 2")), QStringLiteral("Seat 2"));
    EXPECT_EQ(isolated(QStringLiteral("a\u202eb\u2069")), QStringLiteral("\u2068a\u202eb\u2069"));
    EXPECT_EQ(isolated(isolated(QStringLiteral("\u05de"))), QStringLiteral("\u2068\u05de\u2069"));
    EXPECT_EQ(translated(Message{"Move %1", {"\u202eSeat"}}), QStringLiteral("Move \u2068\u202eSeat\u2069"));
}

TEST(Units, AreShownAsTheyAreChosen)
{
    EXPECT_EQ(lengthText(314.325), "314.3 mm");
    EXPECT_EQ(lengthText(-0.04), "0 mm");
    EXPECT_EQ(steadyLengthText(-0.04), steadyLengthText(0)) << "without a sign";
    {
        const StyledNumbers centimetres({LengthUnit::Centimetres, 16, DecimalSign::Point});
        EXPECT_EQ(lengthText(314.325), "31.43 cm");
        EXPECT_EQ(sizeText(250, 120), QStringLiteral("25 \u00d7 12 cm"));
        EXPECT_EQ(steadyLengthText(5), "0.50 cm");
        EXPECT_EQ(longLengthText(4713), "4.71 m");
        EXPECT_EQ(areaText(1.25e6), QStringLiteral("1.25 m\u00b2"));
    }
    {
        const StyledNumbers inches(inInches(16));
        EXPECT_EQ(lengthText(314.325), QStringLiteral("12 3/8\u2033"));
        EXPECT_EQ(lengthText(-314.325), QStringLiteral("-12 3/8\u2033"));
        EXPECT_EQ(lengthText(304.8), QStringLiteral("12\u2033"));
        EXPECT_EQ(lengthText(0), QStringLiteral("0\u2033"));
        EXPECT_EQ(lengthText(12.7), QStringLiteral("1/2\u2033"));
        EXPECT_EQ(lengthText(25.3), QStringLiteral("1\u2033")) << "the nearest part";
        EXPECT_EQ(lengthText(0.4), QStringLiteral("0.016\u2033")) << "which says nothing of what is so thin";
        EXPECT_EQ(sizeText(254, 127), QStringLiteral("10 \u00d7 5\u2033"));
        EXPECT_EQ(longLengthText(4713), "15.5 ft");
        EXPECT_EQ(areaText(1.25e6), QStringLiteral("13.5 ft\u00b2"));
        EXPECT_EQ(sizesText({12.7, 0.4}, 1), QStringLiteral("0.5 \u00d7 0.016\u2033")) << "no two notations";
    }
    const StyledNumbers decimals(inInches(0));
    EXPECT_EQ(lengthText(314.325), QStringLiteral("12.375\u2033"));
}

TEST(Units, FractionsAreTypedAsOnATapeMeasure)
{
    EXPECT_DOUBLE_EQ(typedLength("12 3/8\""), 314.325);
    EXPECT_DOUBLE_EQ(typedLength("12 3/8 in"), 314.325);
    EXPECT_DOUBLE_EQ(typedLength("12 3/8\u2033"), 314.325);
    EXPECT_DOUBLE_EQ(typedLength("12\u00bd\""), 317.5);
    EXPECT_DOUBLE_EQ(typedLength("1' 2 3/8\""), 14.375 * 25.4);
    EXPECT_DOUBLE_EQ(typedLength("1'2\""), 14 * 25.4);
    EXPECT_DOUBLE_EQ(typedLength("1' 2"), 14 * 25.4) << "behind feet inches are meant";
    EXPECT_DOUBLE_EQ(typedLength("-1' 2\""), -14 * 25.4);
    EXPECT_DOUBLE_EQ(typedLength("5 ft 1/2 in"), 60.5 * 25.4);
    EXPECT_DOUBLE_EQ(typedLength("1 m 20 cm 5 mm"), 1205);
    EXPECT_DOUBLE_EQ(typedLength("1' 2\" * 2"), 28 * 25.4);
    EXPECT_DOUBLE_EQ(typedLength("1' 2\" + 3 1/2 in - 1 cm"), 17.5 * 25.4 - 10);
    for (const char* text :
         {"1 cm 2 m", "1 m 20", "1\" 2\"", "12 3/0\"", "1 2 3/8", "3 * 1' 2\"", "(1 ft) 2", "1' 2 3"})
        EXPECT_TRUE(std::isnan(typedLength(text))) << text;
}

TEST(Units, AreTypedWhicheverIsShown)
{
    for (const LengthUnit unit : {LengthUnit::Millimetres, LengthUnit::Centimetres, LengthUnit::Inches}) {
        const StyledNumbers style({unit, 16, DecimalSign::Point});
        EXPECT_DOUBLE_EQ(typedLength("3 in"), 76.2);
        EXPECT_DOUBLE_EQ(typedLength("2.5cm"), 25);
        EXPECT_DOUBLE_EQ(typedLength("40 mm"), 40);
        EXPECT_DOUBLE_EQ(typedLength("1' 2 3/8\""), 14.375 * 25.4);
        EXPECT_DOUBLE_EQ(typedLength("7"), 7 * millimetresPerUnit());
        EXPECT_DOUBLE_EQ(typedLength("3*(2+1)"), 9 * millimetresPerUnit());
        EXPECT_DOUBLE_EQ(typedLength("1 cm + 2"), 10 + 2 * millimetresPerUnit());
    }
}

TEST(Units, WhatIsShownIsTypedBackTheSame)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> lengths(-3000, 3000);
    for (const int fraction : {8, 16, 32, 64}) {
        const StyledNumbers style(inInches(fraction));
        for (int part = -20 * fraction; part <= 20 * fraction; ++part) {
            const double length = part * 25.4 / fraction;
            EXPECT_NEAR(typedLength(lengthText(length, 3).toUtf8()), length, 1e-9) << part << '/' << fraction;
        }
        for (int i = 0; i < 500; ++i) {
            const double length = lengths(random);
            EXPECT_NEAR(typedLength(lengthText(length, 3).toUtf8()), length, 25.4 / fraction / 2 + 1e-9);
        }
    }
    for (const DecimalSign sign : {DecimalSign::Comma, DecimalSign::Point})
        for (const NumberStyle style :
             {NumberStyle{LengthUnit::Millimetres, 16, sign}, NumberStyle{LengthUnit::Centimetres, 16, sign},
              NumberStyle{LengthUnit::Inches, 0, sign}}) {
            const StyledNumbers styled(style);
            for (int i = 0; i < 500; ++i) {
                const double length = std::round(1000 * lengths(random)) / 1000;
                EXPECT_NEAR(typedLength(lengthText(length, 3).toUtf8()), length, 2e-4) << length;
            }
        }
}

TEST(Units, TheDecimalSignIsTheChosenOne)
{
    {
        const StyledNumbers comma({LengthUnit::Millimetres, 16, DecimalSign::Comma});
        EXPECT_EQ(lengthText(1234.5), "1234,5 mm");
        EXPECT_EQ(percentText(0.012), "1,2 %");
        EXPECT_DOUBLE_EQ(typedLength("1,500"), 1.5);
    }
    const StyledNumbers point({LengthUnit::Millimetres, 16, DecimalSign::Point});
    EXPECT_EQ(lengthText(1234.5), "1234.5 mm");
    EXPECT_DOUBLE_EQ(typedLength("1.500"), 1.5);
}

TEST(Units, SentencesOfTheModelHaveThem)
{
    const Message length{"%1 is %2 mm long, at least 5 mm", {"Seat 20 mm", "314.3"}};
    EXPECT_EQ(translated(length), "Seat 20 mm is 314.3 mm long, at least 5 mm");
    {
        const StyledNumbers style(inInches(16));
        EXPECT_EQ(translated(length), QStringLiteral("Seat 20 mm is 12 3/8\u2033 long, at least 3/16\u2033"));
        EXPECT_EQ(translated(Message{"%1 mm, %1", {"25.4"}}), QStringLiteral("1\u2033, 25.4"));
    }
    const StyledNumbers style({LengthUnit::Centimetres, 16, DecimalSign::Comma});
    EXPECT_EQ(translated(length), "Seat 20 mm is 31,43 cm long, at least 0,5 cm");
}

TEST(NumberBox, ShowsAndTakesInchesAndKeepsMillimetres)
{
    NumberBox box({millimetreSuffix});
    box.display(314.3);
    EXPECT_EQ(box.text(), "314.3 mm");
    const StyledNumbers style(inInches(16));
    EXPECT_EQ(box.text(), QStringLiteral("12 3/8\u2033")) << "at once";
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(box.finishTyping(), "");
    EXPECT_DOUBLE_EQ(box.value(), 314.3) << "not rounded to what is shown";
    EXPECT_NEAR(typedOver(box, "10 1/2"), 266.7, 1e-9);
    EXPECT_EQ(box.text(), QStringLiteral("10 1/2\u2033"));
    EXPECT_NEAR(typedOver(box, "1' 2 3/8\""), 365.125, 1e-9);
    EXPECT_NEAR(typedOver(box, "2.5 cm"), 25, 1e-9);
    EXPECT_NEAR(typedOver(box, "40 mm"), 40, 1e-9);
    box.display(25.4);
    box.stepUp();
    EXPECT_NEAR(box.value(), 25.4 * 17 / 16, 1e-4) << "from part to part";
    box.display(30);
    box.stepDown();
    EXPECT_NEAR(box.value(), 25.4 * 18 / 16, 1e-4) << "to the next one";
}

TEST(NumberBox, EveryPartOfAnInchStaysWhatItIs)
{
    NumberBox box({millimetreSuffix, 2, -1e5, 1e5});
    for (const int fraction : {16, 64}) {
        const StyledNumbers style(inInches(fraction));
        for (int part = 1; part < 3 * fraction; ++part) {
            const QString text = inchFractionText(12 + static_cast<double>(part) / fraction, fraction);
            EXPECT_NEAR(typedOver(box, text.toUtf8()), 25.4 * (12 + static_cast<double>(part) / fraction), 1e-4);
            EXPECT_EQ(box.text(), text + u'\u2033');
        }
    }
}

TEST(NumberBox, SaysLimitsInTheUnitThatIsShown)
{
    const StyledNumbers style(inInches(16));
    NumberBox box({millimetreSuffix, 2, 0, 254, 1});
    box.display(25.4);
    box.selectAll();
    QTest::keyClicks(&box, "11");
    EXPECT_TRUE(box.finishTyping().contains(QStringLiteral("at most 10\u2033")));
    EXPECT_DOUBLE_EQ(box.value(), 25.4);
}

TEST(PatternGrid, HasRoundPartsOfInches)
{
    const StyledNumbers style(inInches(16));
    EXPECT_DOUBLE_EQ(gridStep(1, 9), 25.4);
    EXPECT_DOUBLE_EQ(coarserGridStep(gridStep(1, 9)), 12 * 25.4);
    for (double scale = 0.002; scale < 20; scale *= 1.3) {
        EXPECT_GE(gridStep(scale) * scale, 9 - 1e-6);
        const RulerStep ruler = rulerStep(scale, 58, 5);
        EXPECT_GE(ruler.length * scale, 58 - 1e-6);
        EXPECT_GE(ruler.length / ruler.parts * scale, 5 - 1e-6);
        EXPECT_LE(scaleBarLength(scale) * scale, 130 + 1e-6);
        const QString label = gridLengthText(ruler.length);
        EXPECT_NEAR(typedLength(label.toUtf8()), ruler.length, 1e-9) << "labels are exact";
    }
}

} // namespace
} // namespace bolster
