#include "ApplyPreferences.h"

#include <QApplication>
#include <QFont>

#include <algorithm>

namespace bolster {

NumberStyle numberStyleOf(const Preferences& preferences)
{
    NumberStyle style;
    style.length = preferences.length == QLatin1String("cm")   ? LengthUnit::Centimetres
                   : preferences.length == QLatin1String("in") ? LengthUnit::Inches
                                                               : LengthUnit::Millimetres;
    style.fraction = preferences.fraction.toInt();
    style.decimal = preferences.decimal == QLatin1String("comma")   ? DecimalSign::Comma
                    : preferences.decimal == QLatin1String("point") ? DecimalSign::Point
                                                                    : DecimalSign::OfLanguage;
    return style;
}

MouseStyle mouseStyleOf(const Preferences& preferences)
{
    MouseStyle style;
    for (const MousePreset& preset : mousePresets())
        if (preferences.mouse == QLatin1String(preset.id))
            style.preset = &preset;
    style.invertZoom = preferences.invertZoom;
    return style;
}

Theme themeOf(const Preferences& preferences)
{
    return static_cast<Theme>(preferences.theme.toInt());
}

QLocale localeOf(const Preferences& preferences)
{
    static const QLocale system; // the default is the system's until another is set
    const QLocale wanted(preferences.language);
    const auto spoken = system.language() == QLocale::C ? QLocale::English : system.language();
    return preferences.language.isEmpty() || wanted.language() == spoken ? system : wanted;
}

void applyStyles(const Preferences& preferences)
{
    NumberStyles::instance().set(numberStyleOf(preferences));
    MouseStyles::instance().set(mouseStyleOf(preferences));
}

void applyLooks(QApplication& application, const Preferences& preferences)
{
    static const QFont own = QApplication::font();
    QFont font = own;
    font.setPointSizeF(own.pointSizeF() * preferences.fontPercent / 100);
    if (font != QApplication::font()) {
        application.setStyleSheet({}); // what wears a style sheet hears of no other font; the theme brings it again
        QApplication::setFont(font);
    }
    applyTheme(application, themeOf(preferences));
}

} // namespace bolster
