// The list of tables in a damaged project file. Private to the library.
#pragma once

#include <QByteArray>

namespace bolster {

/// The first page of a project file, in which SQLite keeps its list of tables (byte 100 on). It is the same in all
/// projects but for the numbers of the tables' first pages; where it is damaged, it is made anew from those of our
/// tables whose words can still be recognised. The page as it is when it is sound, or when none can be.
QByteArray withRepairedSchema(const QByteArray& page);

} // namespace bolster
