// The one list of what is read and written. Dialogs, drag and drop, the command line and messages are made of it,
// and tests compare the documents and the MIME types with it.
#pragma once

#include <QString>
#include <QStringList>

#include <span>
#include <string>

namespace bolster {

/// What is in a file for Bolster. Those from CoverOut on are written, the others are read (designs both).
enum class FileUse {
    Design,
    Frame,
    Scan,
    Pattern,
    Picture, ///< of a fabric
    CoverOut,
    FoamOut,
    SurfaceOut, ///< the solver's own mesh
    FrameOut,   ///< converted
    PatternOut
};

struct FileFormat {
    FileUse use;
    const char* name;           ///< as people call it, in English (formatName); the same for all of its endings
    const char* ending;         ///< without the dot, lower case
    bool refused = false;       ///< may be chosen, for the sake of the remedy that the message says
    const char* mime = nullptr; ///< of what the desktop opens with Bolster
};

/// One row for each use and ending, those of one name together, in the order in which people are told of them.
std::span<const FileFormat> fileFormats();

/// In the language of the windows.
QString formatName(const FileFormat& format);
/// Without the dot.
QStringList endingsOf(FileUse use);
/// One for each ending, as dialogs that write want them: "OBJ (*.obj);;PLY (*.ply)".
QString filtersOf(FileUse use);
/// "*.obj *.OBJ *.ply ..." as file dialogs want it.
QString patternsOf(FileUse use);
/// "OBJ, PLY, STL", for messages; without those that are refused.
std::string namesOf(FileUse use);
/// Whether the ending of the file says so.
bool isFileOf(FileUse use, const QString& file);
/// The file's own ending in lower case, "" without one.
QString endingOf(const QString& file);

} // namespace bolster
