// The languages of the program.
#pragma once

#include <QLocale>

class QCoreApplication;

namespace bolster {

/// Gives the application the words of this locale's language: Bolster's own, and those of Qt's standard
/// buttons and dialogs. What is not translated stays English.
void installTranslations(QCoreApplication& application, const QLocale& locale);

} // namespace bolster
