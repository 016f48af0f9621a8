// Light and dark.
#pragma once

#include <QPalette>

class QApplication;

namespace bolster {

enum class Theme { System, Light, Dark };

/// For what is printed, whatever the window looks like.
QPalette lightPalette();
/// Colours and style of the whole program; may be called again at any time.
void applyTheme(QApplication& application, Theme theme);
/// What was chosen last.
Theme storedTheme();
void storeTheme(Theme theme);

} // namespace bolster
