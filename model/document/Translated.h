// Sentences of design and solver in the language of the window.
#pragma once

#include "Problem.h"

#include <QString>

namespace bolster {

/// The translation that is installed in the application, or English; numbers in the arguments stay as they are.
QString translated(const Message& message);

/// With a capital letter: sentences of design and solver begin with a small one.
QString asSentence(const QString& text);

/// A text that stands in a sentence: one that is written from right to left, or holds marks that turn the
/// direction, does not turn the words around it.
QString isolated(const QString& text);

/// How sentences tell numbers: windows may show lengths in another unit, and decimals with another sign than the
/// language's. Null: as they are.
struct NumbersTold {
    QString (*length)(double millimetres) = nullptr; ///< with its unit
    QString (*decimalSign)() = nullptr;
};
void tellNumbersAs(const NumbersTold& told);

/// "patch 2 "Seat", outline.points: the outline crosses itself ...", as Problem::english.
QString translated(const Problem& problem);

} // namespace bolster
