#include "PatternImport.h"

#include "DrawingReaders.h"
#include "ReadGuarded.h"

#include <QFileInfo>

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
        if (QFileInfo(path).suffix().compare(QLatin1String(format.ending), Qt::CaseInsensitive) == 0) {
            ImportedDrawing imported;
            imported.problem = readGuarded(path, largestPatternFile, watch,
                                           [&](const FileBytes& bytes) { imported.drawing = format.read(bytes); });
            return imported;
        }
    return {std::nullopt,
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a pattern that can be read; DXF and SVG can"),
             {path.toStdString()}}};
}

QStringList patternFileEndings()
{
    QStringList endings;
    for (const PatternFormat& format : patternFormats)
        endings.append(QLatin1String(format.ending));
    return endings;
}

} // namespace bolster
