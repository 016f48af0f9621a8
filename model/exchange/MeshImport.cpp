#include "MeshImport.h"

#include "MeshReaders.h"
#include "MeshRefused.h"
#include "WholeFile.h"

#include <QFileInfo>
#include <QStringDecoder>

#include <new>

namespace bolster {
namespace {

constexpr std::int64_t largestFile = 2'000'000'000;

struct Format {
    const char* ending;
    TriangleMesh (*read)(std::string_view bytes);
};

constexpr Format formats[] = {{"obj", readObj}, {"ply", readPly}, {"stl", readStl}, {"off", readOff}};

/// "armchair.obj:17", "seat.stl (byte 84)"
std::string placeText(const std::string& file, const MeshPlace& place)
{
    switch (place.unit) {
    case MeshPlace::Unit::Line:
        return file + ":" + std::to_string(place.number);
    case MeshPlace::Unit::Byte:
        return file + " (byte " + std::to_string(place.number) + ")";
    case MeshPlace::Unit::File:
        break;
    }
    return file;
}

/// Names of groups come in any encoding; those that are not UTF-8 are taken for Latin-1.
std::string cleanName(const std::string& name)
{
    QStringDecoder utf8(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString decoded = utf8(QByteArrayView(name.data(), static_cast<qsizetype>(name.size())));
    return (utf8.hasError() ? QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())) : decoded)
        .toStdString();
}

ImportedMesh read(const Format& format, const std::string& bytes, const std::string& file)
{
    try {
        TriangleMesh mesh = format.read(bytes);
        for (TriangleMesh::Part& part : mesh.parts)
            part.name = cleanName(part.name);
        return {std::make_shared<const TriangleMesh>(std::move(mesh)), {}};
    } catch (const MeshRefused& refused) {
        std::vector<std::string> args = {placeText(file, refused.place)};
        args.insert(args.end(), refused.args.begin(), refused.args.end());
        return {nullptr, {refused.sentence, std::move(args)}};
    } catch (const std::bad_alloc&) {
        return {nullptr, {QT_TRANSLATE_NOOP("Message", "%1: there is not enough memory for this mesh"), {file}}};
    }
}

} // namespace

ImportedMesh importMesh(const QString& path)
{
    const QFileInfo info(path);
    for (const Format& format : formats) {
        if (info.suffix().compare(QLatin1String(format.ending), Qt::CaseInsensitive) != 0)
            continue;
        const WholeFile file = readWholeFile(path, largestFile);
        if (!file.problem.empty())
            return {nullptr, file.problem};
        return read(format, file.bytes, info.fileName().toStdString());
    }
    return {nullptr,
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a mesh that can be read; OBJ, PLY, STL and OFF can"),
             {path.toStdString()}}};
}

QStringList meshFileEndings()
{
    QStringList endings;
    for (const Format& format : formats)
        endings.append(QLatin1String(format.ending));
    return endings;
}

} // namespace bolster
