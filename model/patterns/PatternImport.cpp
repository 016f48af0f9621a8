#include "PatternImport.h"

#include "DrawingReaders.h"
#include "FileFormats.h"
#include "ReadGuarded.h"

namespace bolster {

namespace {

constexpr std::int64_t largestPatternFile = 200'000'000;

struct PatternFormat {
    const char* ending;
    Drawing (*read)(const FileBytes& bytes);
};

constexpr PatternFormat patternFormats[] = {{"dxf", readDxf}, {"svg", readSvg}};

} // namespace

ImportedDrawing importDrawing(const QString& path, const ImportWatch& watch)
{
    for (const PatternFormat& format : patternFormats)
        if (endingOf(path) == QLatin1String(format.ending)) {
            ImportedDrawing imported;
            imported.problem = readGuarded(path, largestPatternFile, watch,
                                           [&](const FileBytes& bytes) { imported.drawing = format.read(bytes); });
            return imported;
        }
    return {std::nullopt,
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a pattern that can be read; these can: %2"),
             {path.toStdString(), namesOf(FileUse::Pattern)}}};
}

} // namespace bolster
