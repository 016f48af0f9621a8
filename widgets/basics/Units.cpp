#include "Units.h"

#include "LengthFigures.h"
#include "Translated.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bolster {

namespace {

constexpr double millimetresPerInch = 25.4;
constexpr double millimetresPerFoot = 12 * millimetresPerInch;

} // namespace

NumberStyles& NumberStyles::instance()
{
    static NumberStyles styles;
    return styles;
}

void NumberStyles::set(const NumberStyle& style)
{
    if (style == m_now)
        return;
    m_now = style;
    NumbersTold told{nullptr, [] { return numberLocale().decimalPoint(); }};
    if (style.length != LengthUnit::Millimetres)
        told.length = [](double millimetres) { return lengthText(millimetres, 2); };
    tellNumbersAs(told);
    emit changed();
}

QLocale numberLocale()
{
    const QLocale own;
    const DecimalSign wanted = NumberStyles::now().decimal;
    const QString sign = wanted == DecimalSign::Comma ? QStringLiteral(",") : QStringLiteral(".");
    if (wanted == DecimalSign::OfLanguage || own.decimalPoint() == sign)
        return own;
    return wanted == DecimalSign::Comma ? QLocale(QLocale::German, QLocale::Germany)
                                        : QLocale(QLocale::English, QLocale::UnitedStates);
}

double millimetresPerUnit()
{
    switch (NumberStyles::now().length) {
    case LengthUnit::Centimetres:
        return 10;
    case LengthUnit::Inches:
        return millimetresPerInch;
    default:
        return 1;
    }
}

QString lengthUnitName()
{
    switch (NumberStyles::now().length) {
    case LengthUnit::Centimetres:
        return QCoreApplication::translate("Units", "cm");
    case LengthUnit::Inches:
        return QCoreApplication::translate("Units", "in");
    default:
        return QCoreApplication::translate("Units", "mm");
    }
}

QString lengthSuffix()
{
    switch (NumberStyles::now().length) {
    case LengthUnit::Centimetres:
        return QStringLiteral(" cm");
    case LengthUnit::Inches:
        return QStringLiteral("\u2033");
    default:
        return millimetreSuffix;
    }
}

int moreDecimals()
{
    switch (NumberStyles::now().length) {
    case LengthUnit::Centimetres:
        return 1;
    case LengthUnit::Inches:
        return 2;
    default:
        return 0;
    }
}

QString decimalText(double value, int decimals, bool trailingZeros)
{
    QLocale locale = numberLocale();
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const bool isNothing = std::abs(value) < 0.5 * std::pow(10, -decimals); // no "-0.00"
    QString text = locale.toString(isNothing ? 0 : value, 'f', decimals);
    const QString point = locale.decimalPoint();
    if (!trailingZeros && text.contains(point)) {
        while (text.endsWith(locale.zeroDigit()))
            text.chop(1);
        if (text.endsWith(point))
            text.chop(point.size());
    }
    return text;
}

QString inchFractionText(double inches, int fraction)
{
    const auto parts = std::llround(std::abs(inches) * fraction);
    const long long whole = parts / fraction, rest = parts % fraction;
    const long long common = std::gcd(rest, static_cast<long long>(fraction));
    QString text = inches < 0 && parts > 0 ? QStringLiteral("-") : QString();
    if (whole > 0 || rest == 0)
        text += QString::number(whole);
    if (rest > 0)
        text += QStringLiteral("%1%2/%3")
                    .arg(whole > 0 ? QStringLiteral(" ") : QString())
                    .arg(rest / common)
                    .arg(fraction / common);
    return text;
}

QString lengthFigure(double millimetres, int decimals)
{
    return lengthFigures({millimetres}, decimals).front();
}

QString steadyLengthFigure(double millimetres, int decimals)
{
    return decimalText(millimetres / millimetresPerUnit(), decimals + moreDecimals(), true);
}

QString steadyLengthText(double millimetres, int decimals)
{
    return steadyLengthFigure(millimetres, decimals) + lengthSuffix();
}

double nudgeLength(bool far)
{
    if (NumberStyles::now().length != LengthUnit::Inches)
        return far ? 10 : 1;
    return millimetresPerInch / (far ? 2 : 16);
}

QString lengthText(double millimetres, int decimals)
{
    if (NumberStyles::now().length != LengthUnit::Millimetres)
        return lengthFigure(millimetres, decimals) + lengthSuffix();
    return QCoreApplication::translate("Units", "%1 mm").arg(decimalText(millimetres, decimals, false));
}

QString longLengthText(double millimetres)
{
    if (NumberStyles::now().length == LengthUnit::Inches)
        return QCoreApplication::translate("Units", "%1 ft")
            .arg(decimalText(millimetres / millimetresPerFoot, 1, true));
    return QCoreApplication::translate("Units", "%1 m").arg(decimalText(millimetres / 1000, 2, true));
}

QString areaText(double squareMillimetres, int decimals)
{
    if (NumberStyles::now().length == LengthUnit::Inches)
        return QCoreApplication::translate("Units", "%1 ft\u00b2")
            .arg(decimalText(squareMillimetres / (millimetresPerFoot * millimetresPerFoot), decimals - 1, true));
    return QCoreApplication::translate("Units", "%1 m\u00b2")
        .arg(decimalText(squareMillimetres / 1e6, decimals, true));
}

QString sizeText(double width, double height)
{
    return sizesText({width, height});
}

QString sizesText(std::initializer_list<double> sides, int decimals)
{
    return lengthFigures(sides, decimals).join(QStringLiteral(" \u00d7 ")) + lengthSuffix();
}

QString angleText(double degrees)
{
    return QCoreApplication::translate("Units", "%1\u00b0").arg(decimalText(degrees, 1, false));
}

QString percentText(double ratio)
{
    return QCoreApplication::translate("Units", "%1 %").arg(decimalText(100 * ratio, 1, false));
}

} // namespace bolster
