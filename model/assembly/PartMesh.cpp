#include "PartMesh.h"

#include <algorithm>
#include <exception>
#include <new>

namespace bolster {
namespace {

bool hadNoMemory = false;

/// Libraries catch what `new` throws, and say that the file is damaged.
void noteWantOfMemory()
{
    hadNoMemory = true;
    throw std::bad_alloc();
}

AssemblyVerdict why(AssemblyVerdict verdict)
{
    return hadNoMemory && verdict == AssemblyVerdict::Damaged ? AssemblyVerdict::TooMuchMemory : verdict;
}

} // namespace

std::int64_t PartMesh::addPoint(const Vec3& point, std::string_view part)
{
    if (!point.allFinite())
        return notFinite;
    if (!(point.array().abs() <= farthestAssemblyPoint).all())
        throw AssemblyRefused{AssemblyVerdict::TooFar, std::string(part)};
    return m_mesh.addWeldedPoint(point, {});
}

void PartMesh::addFace(std::span<const std::int64_t> corners)
{
    if (std::ranges::find(corners, notFinite) != corners.end()) {
        ++m_leftOut;
        return;
    }
    m_mesh.addFace(corners, {});
    ++m_faces;
}

void PartMesh::send(AssemblyWriter& writer, std::uint32_t part)
{
    if (m_faces == 0)
        return;
    TriangleMesh mesh;
    try {
        mesh = m_mesh.finish();
    } catch (const FileRefused&) { // every face had shrunk to a line
        return;
    }
    writer.addMesh(part, mesh);
}

int writeAssembly(const AssemblyWriter::Sink& sink, const std::function<void(AssemblyWriter&)>& read)
{
    AssemblyWriter writer(sink);
    std::set_new_handler(noteWantOfMemory);
    try {
        read(writer);
        writer.end(writer.triangleCount() > 0 ? AssemblyVerdict::Read : AssemblyVerdict::NoFaces);
    } catch (const AssemblyRefused& refused) {
        writer.end(why(refused.verdict), refused.text);
    } catch (const FileRefused&) { // MeshBuilder, of more than it takes
        writer.end(AssemblyVerdict::TooLarge);
    } catch (const std::bad_alloc&) {
        writer.end(AssemblyVerdict::TooMuchMemory);
    } catch (const std::exception&) {
        return 3;
    }
    return 0;
}

} // namespace bolster
