#include "ByteReader.h"
#include "MeshBuilder.h"
#include "MeshReaders.h"
#include "TextScanner.h"

#include <algorithm>
#include <cctype>

namespace bolster {
namespace {

constexpr std::uint64_t headerBytes = 80;
constexpr std::uint64_t triangleBytes = 50; // normal and three corners as floats, and two bytes for colour

bool isWord(std::string_view word, std::string_view lowerCase)
{
    return std::equal(word.begin(), word.end(), lowerCase.begin(), lowerCase.end(),
                      [](unsigned char a, char b) { return std::tolower(a) == b; });
}

TriangleMesh readBinaryTriangles(const FileBytes& bytes)
{
    ByteReader reader(bytes, false);
    reader.skip(headerBytes);
    const std::uint64_t count = reader.read<std::uint32_t>();
    reader.require(count, triangleBytes);

    MeshBuilder mesh;
    std::array<std::int64_t, 3> corners{};
    for (std::uint64_t i = 0; i < count; ++i) {
        reader.skip(3 * sizeof(float)); // the normal follows from the corners
        for (std::int64_t& corner : corners) {
            const FilePlace place = reader.place();
            const Vec3 point{reader.read<float>(), reader.read<float>(), reader.read<float>()};
            corner = mesh.addWeldedPoint(point, place);
        }
        mesh.addFace(corners, reader.place());
        reader.skip(sizeof(std::uint16_t));
    }
    return mesh.finish();
}

TriangleMesh readTextTriangles(const FileBytes& bytes)
{
    TextScanner text(bytes);
    MeshBuilder mesh;
    std::vector<std::int64_t> corners;
    while (text.nextLine()) {
        const std::string_view keyword = text.word();
        if (isWord(keyword, "solid")) {
            mesh.beginPart(text.restOfLine());
        } else if (isWord(keyword, "vertex")) {
            const Vec3 point{text.number(), text.number(), text.number()};
            corners.push_back(mesh.addWeldedPoint(point, text.place()));
        } else if (isWord(keyword, "facet") || isWord(keyword, "endfacet")) {
            mesh.addFace(corners, text.place());
            corners.clear();
        }
    }
    if (!corners.empty())
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file ends too early"));
    return mesh.finish();
}

/// Some programs begin binary files with "solid" too, so the size decides first.
bool isBinary(const FileBytes& bytes)
{
    if (bytes.size() < headerBytes + sizeof(std::uint32_t))
        return false;
    ByteReader reader(bytes, false);
    reader.skip(headerBytes);
    const std::uint64_t count = reader.read<std::uint32_t>();
    if (reader.bytesLeft() == count * triangleBytes)
        return true;
    const std::string beginning(FileWindow(bytes).view(0, 512).substr(0, 512));
    TextScanner text{FileBytes(beginning)};
    return !(text.nextLine() && isWord(text.word(), "solid"));
}

} // namespace

TriangleMesh readStl(const FileBytes& bytes)
{
    return isBinary(bytes) ? readBinaryTriangles(bytes) : readTextTriangles(bytes);
}

} // namespace bolster
