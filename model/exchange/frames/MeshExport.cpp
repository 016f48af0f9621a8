#include "MeshExport.h"

#include "ExportBytes.h"
#include "FileFormats.h"
#include "WholeFile.h"

#include <set>

namespace bolster {
namespace {

/// Two parts may differ in nothing but such characters.
std::string objName(const std::string& name, std::set<std::string>& taken)
{
    const std::string safe = name.empty() ? "part" : safeName(name);
    std::string free = safe;
    for (int i = 2; !taken.insert(free).second; ++i)
        free = safe + "-" + std::to_string(i);
    return free;
}

std::string objText(const TriangleMesh& mesh, const std::string& note)
{
    constexpr std::size_t usualLine = 56; // of a point, and of two triangles
    std::string text = "# Frame by Bolster: " + note + "\n";
    text.reserve(usualLine * (mesh.points.size() + mesh.triangles.size() / 2));
    for (const Vec3& point : mesh.points)
        appendLine(text, "v", point);
    std::set<std::string> names;
    for (const TriangleMesh::Part& part : mesh.parts) {
        text += "g " + objName(part.name, names) + '\n';
        for (std::uint32_t i = 0; i < part.triangleCount; ++i) {
            const auto& [a, b, c] = mesh.triangles[part.firstTriangle + i];
            appendLine(text, "f", std::array{a + 1, b + 1, c + 1});
        }
    }
    return text;
}

std::string plyBytes(const TriangleMesh& mesh, const std::string& note)
{
    std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment Frame by Bolster: " + note + "\n";
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        bytes += "comment part " + std::to_string(i) + ": " + safeName(mesh.parts[i].name) + '\n';
    bytes += "element vertex " + std::to_string(mesh.points.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
             std::to_string(mesh.triangles.size()) +
             "\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n";
    bytes.reserve(bytes.size() + 24 * mesh.points.size() + 17 * mesh.triangles.size());
    for (const Vec3& point : mesh.points)
        for (const double coordinate : point)
            appendRaw(bytes, coordinate);
    for (std::size_t part = 0; part < mesh.parts.size(); ++part)
        for (std::uint32_t i = 0; i < mesh.parts[part].triangleCount; ++i) {
            appendRaw(bytes, std::uint8_t{3});
            for (const std::uint32_t corner : mesh.triangles[mesh.parts[part].firstTriangle + i])
                appendRaw(bytes, static_cast<std::int32_t>(corner));
            appendRaw(bytes, static_cast<std::int32_t>(part));
        }
    return bytes;
}

std::string stlBytes(const TriangleMesh& mesh, const std::string& note)
{
    std::string bytes = "Frame by Bolster: " + note;
    bytes.resize(80, ' ');
    bytes.reserve(84 + 50 * mesh.triangles.size());
    appendRaw(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 normal = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).normalized();
        for (const Vec3& vector : {normal, mesh.points[a], mesh.points[b], mesh.points[c]})
            for (const double coordinate : vector)
                appendRaw(bytes, static_cast<float>(coordinate));
        appendRaw(bytes, std::uint16_t{0});
    }
    return bytes;
}

struct MeshWriter {
    const char* ending;
    std::string (*bytes)(const TriangleMesh& mesh, const std::string& note);
};

constexpr MeshWriter meshWriters[] = {{"obj", objText}, {"ply", plyBytes}, {"stl", stlBytes}};

} // namespace

bool isMeshExport(const QString& ending)
{
    return std::ranges::any_of(meshWriters,
                               [&](const MeshWriter& writer) { return ending == QLatin1String(writer.ending); });
}

Message writeMesh(const TriangleMesh& mesh, const QString& path, const std::string& note)
{
    for (const MeshWriter& writer : meshWriters)
        if (endingOf(path) == QLatin1String(writer.ending))
            return replaceWholeFile(path, writer.bytes(mesh, note));
    return {QT_TRANSLATE_NOOP("Message", "\"%1\" is no file that frames are written to; OBJ, PLY and STL are"),
            {path.toStdString()}};
}

} // namespace bolster
