#include "LengthFigures.h"

#include "Units.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// Small lengths would be told wrong by their nearest fraction; then decimals say them.
bool fractionSays(double inches, int fraction)
{
    constexpr double mostOff = 0.1; // of the length
    const double shown = std::round(inches * fraction) / fraction;
    return std::abs(shown - inches) <= mostOff * std::abs(inches) + 1e-9;
}

} // namespace

QStringList lengthFigures(const std::vector<double>& millimetres, int decimals)
{
    const NumberStyle& style = NumberStyles::now();
    const auto inParts = [&](double length) {
        constexpr double mostInParts = 1e7; // inches
        const double shown = length / millimetresPerUnit();
        return std::abs(shown) < mostInParts && fractionSays(shown, style.fraction);
    };
    const bool fractions =
        style.length == LengthUnit::Inches && style.fraction > 0 && std::ranges::all_of(millimetres, inParts);
    QStringList figures;
    for (const double length : millimetres) {
        const double shown = length / millimetresPerUnit();
        figures << (fractions ? inchFractionText(shown, style.fraction)
                              : decimalText(shown, decimals + moreDecimals(), false));
    }
    return figures;
}

} // namespace bolster
