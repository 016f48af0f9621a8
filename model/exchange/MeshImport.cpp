#include "MeshImport.h"

#include "AssemblyImport.h"
#include "FileFormats.h"
#include "MeshReaders.h"
#include "PartNames.h"
#include "ReadGuarded.h"

namespace bolster {
namespace {

struct MeshFormat {
    const char* ending;
    TriangleMesh (*read)(const FileBytes& bytes);
};

constexpr std::int64_t largestMeshFile = 2'000'000'000;

constexpr MeshFormat meshFormats[] = {{"obj", readObj}, {"ply", readPly}, {"stl", readStl}, {"off", readOff}};

/// What our own files say in their first lines.
FileFacts factsByBolster(const FileBytes& bytes)
{
    FileWindow window(bytes.quietly());
    const std::string_view begin = window.view(0, 300).substr(0, 300);
    if (begin.find(" by Bolster: millimetres, z up") == std::string_view::npos)
        return {};
    return {1, UpAxis::Z};
}

ImportedMesh allOf(ImportedAssembly imported)
{
    ImportedMesh all{nullptr, std::move(imported.problem)};
    if (!imported.warnings.empty())
        all.warning = std::move(imported.warnings.front());
    all.beside = std::move(imported.beside);
    if (imported.assembly) {
        all.said = imported.assembly->said;
        all.tree = outlinesOf(*imported.assembly);
        all.edges = edgesOf(*imported.assembly);
        all.mesh =
            std::make_shared<const TriangleMesh>(meshOf(*imported.assembly, [](std::uint32_t) { return true; }));
    }
    return all;
}

} // namespace

ImportedMesh importMesh(const QString& path, const ImportWatch& watch, bool withEdges)
{
    const QString ending = endingOf(path);
    if (isAssemblyEnding(ending))
        return allOf(importAssembly(path, watch, {usualTolerance, withEdges}));
    for (const MeshFormat& format : meshFormats) {
        if (ending != QLatin1String(format.ending))
            continue;
        ImportedMesh imported;
        imported.problem =
            readGuarded(path, largestMeshFile, warning(watch, path, imported.warning), [&](const FileBytes& bytes) {
                imported.said = factsByBolster(bytes);
                TriangleMesh mesh = format.read(bytes);
                for (TriangleMesh::Part& part : mesh.parts)
                    part.name = cleanName(part.name);
                imported.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
            });
        return imported;
    }
    return {nullptr,
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a frame that can be read; these can: %2"),
             {path.toStdString(), namesOf(FileUse::Frame)}}};
}

} // namespace bolster
