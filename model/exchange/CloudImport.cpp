#include "CloudImport.h"

#include "CloudReaders.h"
#include "ReadGuarded.h"

#include <QFileInfo>

namespace bolster {
namespace {

struct CloudFormat {
    const char* ending;
    PointCloud (*read)(const FileBytes& bytes);
};

constexpr std::int64_t largestCloudFile = 1'000'000'000'000; // only pieces of it are in memory

constexpr CloudFormat cloudFormats[] = {{"e57", readE57},     {"las", readLas},    {"laz", readLas},
                                        {"ptx", readPtx},     {"pts", readPts},    {"ply", readPlyScan},
                                        {"xyz", readXyz},     {"pcd", readPcd},    {"obj", readObjScan},
                                        {"stl", readStlScan}, {"off", readOffScan}};

} // namespace

ImportedCloud importCloud(const QString& path, const ImportWatch& watch)
{
    for (const CloudFormat& format : cloudFormats) {
        if (QFileInfo(path).suffix().compare(QLatin1String(format.ending), Qt::CaseInsensitive) != 0)
            continue;
        ImportedCloud imported;
        imported.problem = readGuarded(path, largestCloudFile, warning(watch, path, imported.warning),
                                       [&](const FileBytes& bytes) {
                                           imported.cloud = std::make_shared<const PointCloud>(format.read(bytes));
                                       });
        return imported;
    }
    return {nullptr,
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a scan that can be read; E57, LAS, PTX, PTS, PLY, XYZ, "
                                          "PCD, OBJ, STL and OFF can"),
             {path.toStdString()}},
            {}};
}

QStringList cloudFileEndings()
{
    QStringList endings;
    for (const CloudFormat& format : cloudFormats)
        endings.append(QLatin1String(format.ending));
    return endings;
}

} // namespace bolster
