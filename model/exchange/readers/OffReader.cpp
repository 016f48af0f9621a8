#include "MeshBuilder.h"
#include "MeshReaders.h"
#include "TextScanner.h"

namespace bolster {
namespace {

/// "OFF" with the marks for texture coordinates, colours and normals, which follow the coordinates.
bool isHeader(std::string_view word)
{
    for (const std::string_view mark : {"ST", "C", "N"})
        if (word.starts_with(mark))
            word.remove_prefix(mark.size());
    return word == "OFF";
}

void requireBytes(const TextScanner& text, std::uint64_t rows, std::uint64_t bytesPerRow)
{
    if (rows > (text.bytesLeft() + 1) / bytesPerRow)
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
}

void requireLine(TextScanner& text)
{
    if (!text.nextLine())
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file ends too early"));
}

} // namespace

TriangleMesh readOff(const FileBytes& bytes)
{
    TextScanner text(bytes);
    if (!text.nextLine() || !isHeader(text.word()))
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file does not begin with OFF"));
    std::string_view word = text.wordOnAnyLine();
    if (word == "BINARY")
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: binary OFF is not read; save it as text"));
    const std::uint64_t pointCount = text.count(word);
    const std::uint64_t faceCount = text.count();
    requireBytes(text, pointCount, sizeof("0 0 0"));
    requireBytes(text, faceCount, sizeof("0"));

    MeshBuilder mesh;
    mesh.reservePoints(faceCount > 0 ? pointCount : 0, text.place());
    for (std::uint64_t i = 0; i < pointCount; ++i) {
        requireLine(text);
        const Vec3 point{text.number(), text.number(), text.number()};
        mesh.addPoint(point, text.place());
    }
    std::vector<std::int64_t> corners;
    for (std::uint64_t i = 0; i < faceCount; ++i) {
        requireLine(text);
        const std::uint64_t size = text.count();
        requireBytes(text, size, sizeof("0"));
        corners.clear();
        for (std::uint64_t k = 0; k < size; ++k)
            corners.push_back(text.integer());
        mesh.addFace(corners, text.place());
    }
    return mesh.finish();
}

} // namespace bolster
