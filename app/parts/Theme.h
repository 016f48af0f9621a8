// Light, dark, and with high contrast.
#pragma once

#include <QPalette>

class QApplication;

namespace bolster {

/// Settings keep their numbers.
enum class Theme { System, Light, Dark, HighContrast };

/// For what is printed, whatever the window looks like.
QPalette lightPalette();
/// Colours and style of the whole program; may be called again at any time.
void applyTheme(QApplication& application, Theme theme);

} // namespace bolster
