// What people type where a length is wanted: "3*25 mm", "2.5 cm", "1/2 in", "1' 2 3/8\"".
#pragma once

#include "Units.h"

#include <optional>

namespace bolster {

/// In mm. Sums, products and quotients with brackets and the units mm, cm, m, in (also inch and "), ft (also ');
/// without one it is the unit that lengths are shown in. A unit belongs to the whole product before it, so "1/2 in"
/// is 12.7 mm, and each summand has its own. A fraction behind a whole number is added ("12 3/8"), and so are
/// smaller units behind a length ("1' 2 3/8\"", "1 m 20 cm"; behind feet also without a unit). Takes point and
/// comma as the decimal sign, but only the language's if both occur, and "1,500" as the language groups digits.
/// Nothing when it is no finite length.
std::optional<double> parseLength(const QString& text, const QLocale& locale = numberLocale());

/// The same without units: for angles, numbers and factors.
std::optional<double> parseNumber(const QString& text, const QLocale& locale = numberLocale());

} // namespace bolster
