#include "SeamEase.h"

#include "DesignCheck.h"
#include "StretchLength.h"
#include "Units.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

QString withSign(double value, const QString& text)
{
    return value > 0 ? QStringLiteral("+") + text : text;
}

/// What is shown as 0 has no sign.
double rounded(double value, double step)
{
    return std::abs(value) < 0.5 * step ? 0 : value;
}

} // namespace

double SeamEase::ratio() const
{
    return known() ? difference() / std::min(a, b) : 0;
}

bool SeamEase::puckers() const
{
    return known() && bolster::puckers(a, b, wanted);
}

QString SeamEase::differenceText() const
{
    const double shown = rounded(difference(), 0.1);
    return known() ? withSign(shown, lengthText(shown)) : QString();
}

QString SeamEase::ratioText() const
{
    const double shown = rounded(ratio(), 0.001);
    return known() ? withSign(shown, percentText(shown)) : QString();
}

SeamEase seamEaseOf(const Design& design, const Seam& seam)
{
    return {stretchLength(design, seam.a), stretchLength(design, seam.b), seam.ease};
}

} // namespace bolster
