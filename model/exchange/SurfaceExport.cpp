#include "SurfaceExport.h"

#include "ExportBytes.h"
#include "WholeFile.h"

#include <set>

namespace bolster {
namespace {

std::string groupName(const Design& design, ElementId id, std::set<std::string>& taken)
{
    const Patch* patch = design.find<Patch>(id);
    const std::string numbered = "patch_" + std::to_string(number(id));
    std::string name = patch && !patch->name.empty() ? safeName(patch->name) : numbered;
    while (!taken.insert(name).second)
        name += "_" + numbered;
    return name;
}

void appendFace(std::string& text, const std::array<std::uint32_t, 3>& triangle)
{
    text += 'f';
    for (const std::uint32_t vertex : triangle) {
        for (const char before : {' ', '/', '/'}) {
            text += before;
            appendNumber(text, vertex + 1);
        }
    }
    text += '\n';
}

std::string plyHeader(std::size_t vertices, std::size_t triangles)
{
    return "ply\n"
           "format binary_little_endian 1.0\n"
           "comment Cover by Bolster: millimetres, z up; s and t are pattern millimetres\n"
           "element vertex " +
           std::to_string(vertices) +
           "\n"
           "property double x\nproperty double y\nproperty double z\n"
           "property float nx\nproperty float ny\nproperty float nz\n"
           "property float s\nproperty float t\n"
           "element face " +
           std::to_string(triangles) +
           "\n"
           "property list uchar int vertex_indices\n"
           "property int patch\n"
           "end_header\n";
}

} // namespace

Message exportObj(const SurfaceMesh& surface, const Design& design, const QString& path)
{
    const SurfaceTopology& topology = *surface.topology;
    std::string text = "# Cover by Bolster: millimetres, z up; texture coordinates are pattern millimetres\n";
    for (const Vec3& position : surface.positions)
        appendLine(text, "v", position);
    for (const Vec2& point : topology.pattern)
        appendLine(text, "vt", point);
    for (const Eigen::Vector3f& normal : surface.normals)
        appendLine(text, "vn", normal);
    std::set<std::string> names;
    for (const SurfaceTopology::PatchRange& patch : topology.patches) {
        text += "g " + groupName(design, patch.patch, names) + '\n';
        for (std::uint32_t i = 0; i < patch.triangleCount; ++i)
            appendFace(text, topology.triangles[patch.firstTriangle + i]);
    }
    return replaceWholeFile(path, text);
}

Message exportPly(const SurfaceMesh& surface, const Design&, const QString& path)
{
    const SurfaceTopology& topology = *surface.topology;
    std::string bytes = plyHeader(surface.positions.size(), topology.triangles.size());
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        for (const double coordinate : surface.positions[i])
            appendRaw(bytes, coordinate);
        for (const float coordinate : surface.normals[i])
            appendRaw(bytes, coordinate);
        for (const double coordinate : topology.pattern[i])
            appendRaw(bytes, static_cast<float>(coordinate));
    }
    for (const SurfaceTopology::PatchRange& patch : topology.patches) {
        for (std::uint32_t i = 0; i < patch.triangleCount; ++i) {
            appendRaw(bytes, std::uint8_t{3});
            for (const std::uint32_t vertex : topology.triangles[patch.firstTriangle + i])
                appendRaw(bytes, static_cast<std::int32_t>(vertex));
            appendRaw(bytes, static_cast<std::int32_t>(number(patch.patch)));
        }
    }
    return replaceWholeFile(path, bytes);
}

} // namespace bolster
