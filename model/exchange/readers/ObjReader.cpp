#include "MeshBuilder.h"
#include "MeshReaders.h"
#include "TextScanner.h"

namespace bolster {
namespace {

/// "7", "7/1", "7/1/3", "7//3" or "-1": the point alone, as an index from 0.
std::int64_t pointIndex(const TextScanner& text, std::string_view corner, std::uint64_t pointCount)
{
    const std::int64_t index = text.integer(corner.substr(0, corner.find('/')));
    if (index == 0)
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: points are counted from 1, not from 0"));
    if (index < -static_cast<std::int64_t>(pointCount))
        refuseFile(text.place(),
                   QT_TRANSLATE_NOOP("Message", "%1: a face refers to point %2, but there are %3 points"),
                   {std::to_string(index), std::to_string(pointCount)});
    return index > 0 ? index - 1 : index + static_cast<std::int64_t>(pointCount);
}

} // namespace

TriangleMesh readObj(const FileBytes& bytes)
{
    TextScanner text(bytes);
    MeshBuilder mesh;
    std::vector<std::int64_t> corners;
    while (text.nextLine()) {
        const std::string_view keyword = text.word();
        if (keyword == "v") {
            const Vec3 point{text.number(), text.number(), text.number()};
            mesh.addPoint(point, text.place());
        } else if (keyword == "f" || keyword == "fo") {
            corners.clear();
            for (std::string_view corner = text.word(); !corner.empty(); corner = text.word())
                corners.push_back(pointIndex(text, corner, mesh.pointCount()));
            mesh.addFace(corners, text.place());
        } else if (keyword == "g" || keyword == "o") {
            mesh.beginPart(text.restOfLine());
        }
    }
    return mesh.finish();
}

} // namespace bolster
