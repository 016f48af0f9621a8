// The one list of what is read from elsewhere. Dialogs, drag and drop, the command line and messages are made of
// it, and a test compares the documents with it.
#pragma once

#include <QStringList>

#include <span>
#include <string>

namespace bolster {

enum class FileUse { Design, Frame, Scan, Pattern, Picture };

struct FileFormat {
    FileUse use;
    const char* name;   ///< as people call it; the same for all of its endings
    const char* ending; ///< without the dot, lower case
};

/// One row for each use and ending, those of one name together, in the order in which people are told of them.
std::span<const FileFormat> readFormats();

/// Without the dot.
QStringList endingsOf(FileUse use);
/// "*.obj *.OBJ *.ply ..." as file dialogs want it.
QString patternsOf(FileUse use);
/// "OBJ, PLY, STL", for messages.
std::string namesOf(FileUse use);
/// Whether the ending of the file says so.
bool isFileOf(FileUse use, const QString& file);
/// The file's own ending in lower case, "" without one.
QString endingOf(const QString& file);

} // namespace bolster
