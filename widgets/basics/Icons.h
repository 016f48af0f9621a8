// The program's icons in the colours of the palette.
#pragma once

#include <QIcon>
#include <QPixmap>

namespace bolster {

/// resources/icons/NAME.svg; follows changes of the palette.
QIcon icon(const QString& name);
/// The same in one colour.
QIcon icon(const QString& name, const QColor& color);
/// A round spot of colour, for lists.
QIcon colorSpot(const QColor& color);

} // namespace bolster
