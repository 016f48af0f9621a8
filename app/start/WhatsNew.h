// What this version of the program has that the one before had not: docs/whats-new.md, compiled in.
#pragma once

#include <QString>

class QWidget;

namespace bolster {

/// Markdown.
QString whatsNewText();
/// Whether the program was started before as another version than this one; asked once for each version.
bool newSinceLastStart(const QString& version);
void showWhatsNew(QWidget* window);

} // namespace bolster
