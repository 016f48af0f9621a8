// What settings may be chosen from.
#pragma once

#include "Preferences.h"

namespace bolster {

QList<PreferenceChoice> lengthChoices();
QList<PreferenceChoice> fractionChoices();
QList<PreferenceChoice> decimalChoices();
/// The system's, then those that are compiled in, by the names that they have themselves.
QList<PreferenceChoice> languageChoices();
QList<PreferenceChoice> themeChoices();
QList<PreferenceChoice> mouseChoices();
QList<PreferenceChoice> keyChoices();
QList<PreferenceChoice> drawingChoices();
QList<PreferenceChoice> fabricChoices();

} // namespace bolster
