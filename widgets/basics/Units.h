// Numbers with units for people, in the language of the system.
#pragma once

#include <QString>

namespace bolster {

/// "12.5 mm", at most `decimals` behind the point and no trailing zeros.
QString lengthText(double millimetres, int decimals = 1);
/// "250 x 120 mm" with a proper multiplication sign.
QString sizeText(double width, double height);
QString angleText(double degrees);
/// A ratio of 0.012 is "1.2 %".
QString percentText(double ratio);
QString decimalText(double value, int decimals, bool trailingZeros);

} // namespace bolster
