#include "MeshImport.h"

#include "MeshReaders.h"
#include "ReadGuarded.h"

#include <QFileInfo>
#include <QStringDecoder>

namespace bolster {
namespace {

struct MeshFormat {
    const char* ending;
    TriangleMesh (*read)(const FileBytes& bytes);
};

constexpr std::int64_t largestMeshFile = 2'000'000'000;

constexpr MeshFormat meshFormats[] = {{"obj", readObj}, {"ply", readPly}, {"stl", readStl}, {"off", readOff}};

/// Names of groups come in any encoding; those that are not UTF-8 are taken for Latin-1.
std::string cleanName(const std::string& name)
{
    QStringDecoder utf8(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString decoded = utf8(QByteArrayView(name.data(), static_cast<qsizetype>(name.size())));
    return (utf8.hasError() ? QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())) : decoded)
        .toStdString();
}

} // namespace

ImportedMesh importMesh(const QString& path, const ImportWatch& watch)
{
    for (const MeshFormat& format : meshFormats) {
        if (QFileInfo(path).suffix().compare(QLatin1String(format.ending), Qt::CaseInsensitive) != 0)
            continue;
        ImportedMesh imported;
        imported.problem =
            readGuarded(path, largestMeshFile, warning(watch, path, imported.warning), [&](const FileBytes& bytes) {
                TriangleMesh mesh = format.read(bytes);
                for (TriangleMesh::Part& part : mesh.parts)
                    part.name = cleanName(part.name);
                imported.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
            });
        return imported;
    }
    return {nullptr,
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a mesh that can be read; OBJ, PLY, STL and OFF can"),
             {path.toStdString()}},
            {}};
}

QStringList meshFileEndings()
{
    QStringList endings;
    for (const MeshFormat& format : meshFormats)
        endings.append(QLatin1String(format.ending));
    return endings;
}

} // namespace bolster
