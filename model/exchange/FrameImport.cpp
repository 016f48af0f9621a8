#include "FrameImport.h"

#include "FileFormats.h"
#include "MeshImport.h"

#include <limits>

namespace bolster {
namespace {

Assembly assemblyOf(const TriangleMesh& mesh)
{
    constexpr auto none = std::numeric_limits<std::uint32_t>::max();
    Assembly assembly;
    std::vector<std::uint32_t> own(mesh.points.size(), none); // of each point its number in the part
    for (const TriangleMesh::Part& group : mesh.parts) {
        Assembly::Part& part = assembly.parts.emplace_back();
        part.name = group.name;
        std::vector<std::uint32_t> used;
        for (std::uint32_t i = 0; i < group.triangleCount; ++i) {
            std::array<std::uint32_t, 3> triangle = mesh.triangles[group.firstTriangle + i];
            for (std::uint32_t& corner : triangle) {
                if (own[corner] == none) {
                    own[corner] = static_cast<std::uint32_t>(used.size());
                    used.push_back(corner);
                    part.points.push_back(mesh.points[corner]);
                }
                corner = own[corner];
            }
            part.triangles.push_back(triangle);
        }
        for (const std::uint32_t point : used)
            own[point] = none;
    }
    return assembly;
}

} // namespace

ImportedAssembly importFrameParts(const QString& path, const ImportWatch& watch, const AssemblyOrder& order)
{
    if (isAssemblyEnding(endingOf(path)))
        return importAssembly(path, watch, order);
    ImportedMesh imported = importMesh(path, watch);
    ImportedAssembly parts{nullptr, std::move(imported.problem)};
    if (!imported.warning.empty())
        parts.warnings.push_back(std::move(imported.warning));
    if (imported.mesh) {
        Assembly assembly = assemblyOf(*imported.mesh);
        assembly.said = imported.said;
        parts.assembly = std::make_shared<const Assembly>(std::move(assembly));
    }
    return parts;
}

std::vector<bool> partsNamed(const Assembly& assembly, std::set<std::string>& names)
{
    std::vector<bool> named(assembly.parts.size());
    std::set<std::string> found;
    for (std::size_t i = 0; i < named.size(); ++i) {
        const Assembly::Part& part = assembly.parts[i];
        const bool own = names.contains(part.name);
        if (own)
            found.insert(part.name);
        named[i] = own || (part.parent && named[*part.parent]);
    }
    for (const std::string& name : found)
        names.erase(name);
    return named;
}

std::vector<std::size_t> depthsOf(const Assembly& assembly)
{
    std::vector<std::size_t> depths;
    for (const Assembly::Part& part : assembly.parts)
        depths.push_back(part.parent ? depths[*part.parent] + 1 : 0);
    return depths;
}

} // namespace bolster
