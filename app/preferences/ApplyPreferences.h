// Preferences that hold for the whole program.
#pragma once

#include "MouseStyle.h"
#include "Preferences.h"
#include "Theme.h"
#include "Units.h"

class QApplication;

namespace bolster {

NumberStyle numberStyleOf(const Preferences& preferences);
MouseStyle mouseStyleOf(const Preferences& preferences);
Theme themeOf(const Preferences& preferences);
/// The language that was chosen, with the system's way to write where it speaks that language, too.
QLocale localeOf(const Preferences& preferences);

/// Units, numbers and mouse.
void applyStyles(const Preferences& preferences);
/// Theme and letters; not done twice for the same.
void applyLooks(QApplication& application, const Preferences& preferences);

} // namespace bolster
