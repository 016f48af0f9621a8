#include "CloudImport.h"

#include "CloudReaders.h"
#include "ReadGuarded.h"

#include <QFileInfo>

namespace bolster {
namespace {

struct Format {
    const char* ending;
    PointCloud (*read)(std::string_view bytes);
};

constexpr Format formats[] = {{"ply", readPlyCloud}, {"xyz", readXyz}, {"pcd", readPcd}};

} // namespace

ImportedCloud importCloud(const QString& path)
{
    for (const Format& format : formats) {
        if (QFileInfo(path).suffix().compare(QLatin1String(format.ending), Qt::CaseInsensitive) != 0)
            continue;
        ImportedCloud imported;
        imported.problem = readGuarded(path, [&](std::string_view bytes) {
            imported.cloud = std::make_shared<const PointCloud>(format.read(bytes));
        });
        return imported;
    }
    return {nullptr,
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a scan that can be read; PLY, XYZ and PCD can"),
             {path.toStdString()}}};
}

QStringList cloudFileEndings()
{
    QStringList endings;
    for (const Format& format : formats)
        endings.append(QLatin1String(format.ending));
    return endings;
}

} // namespace bolster
