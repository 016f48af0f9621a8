// Light and dark.
#pragma once

class QApplication;

namespace bolster {

enum class Theme { System, Light, Dark };

/// Colours and style of the whole program; may be called again at any time.
void applyTheme(QApplication& application, Theme theme);
/// What was chosen last.
Theme storedTheme();
void storeTheme(Theme theme);

} // namespace bolster
