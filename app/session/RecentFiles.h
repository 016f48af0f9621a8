// The projects and designs that were opened or saved last.
#pragma once

#include <QStringList>

class QFontMetrics;

namespace bolster::recentFiles {

/// Newest first; those that are not there now are left out.
QStringList all();
/// With those that are not there now: their disk may come back.
QStringList remembered();
void add(const QString& path);
void remove(const QString& path);
void clear();
/// The folder of a file, from "~" where it is below that, as long as `width` pixels allow.
QString folderText(const QString& path, const QFontMetrics& metrics, int width);

} // namespace bolster::recentFiles
