#include "Units.h"

#include <QCoreApplication>
#include <QLocale>

namespace bolster {

QString decimalText(double value, int decimals, bool trailingZeros)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QString text = locale.toString(value, 'f', decimals);
    const QString point = locale.decimalPoint();
    if (!trailingZeros && text.contains(point)) {
        while (text.endsWith(locale.zeroDigit()))
            text.chop(1);
        if (text.endsWith(point))
            text.chop(point.size());
    }
    return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

QString lengthText(double millimetres, int decimals)
{
    return QCoreApplication::translate("Units", "%1 mm").arg(decimalText(millimetres, decimals, false));
}

QString sizeText(double width, double height)
{
    return QCoreApplication::translate("Units", "%1 \u00d7 %2 mm")
        .arg(decimalText(width, 0, false), decimalText(height, 0, false));
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
