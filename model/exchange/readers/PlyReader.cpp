#include "CloudBuilder.h"
#include "CloudReaders.h"
#include "MeshBuilder.h"
#include "MeshReaders.h"
#include "PlyBody.h"

namespace bolster {
namespace {

void readFaces(PlyBody& body, const PlyElement& element, MeshBuilder& mesh)
{
    const auto indices = element.find("vertex_indices", "vertex_index");
    if (!indices || !element.properties[*indices].countType || !isInteger(element.properties[*indices].type))
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: the faces have no list \"%2\""), {"vertex_indices"});
    std::vector<std::int64_t> corners;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        const FilePlace place = body.place();
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (k != *indices) {
                body.skip(property);
                continue;
            }
            corners.resize(body.listSize(property));
            for (std::int64_t& corner : corners)
                corner = body.integer(property.type);
        }
        body.endRow();
        mesh.addFace(corners, place);
    }
}

template <class Builder>
void readVertices(PlyBody& body, const PlyElement& element, Builder& builder)
{
    builder.reservePoints(element.count, body.place());
    body.eachPoint(element, [&](const Vec3& point, FilePlace place, std::optional<std::uint32_t> color) {
        if constexpr (std::is_same_v<Builder, CloudBuilder>)
            builder.addPoint(point, place, color);
        else
            builder.addPoint(point, place);
    });
}

} // namespace

TriangleMesh readPly(const FileBytes& bytes)
{
    TextScanner text(bytes);
    const PlyHeader header = readPlyHeader(text);
    const PlyElement* faces = header.find("face");
    if (!faces || faces->count == 0)
        refuseFile({}, holdsPointsOnly);

    PlyBody body(header, bytes, text);
    MeshBuilder mesh;
    for (const PlyElement& element : header.elements) {
        body.requireRows(element);
        if (element.properties.empty())
            continue;
        if (element.name == "vertex")
            readVertices(body, element, mesh);
        else if (element.name == "face")
            readFaces(body, element, mesh);
        else
            body.skip(element);
    }
    body.warnOfSurplus();
    return mesh.finish();
}

PointCloud readPlyCloud(const FileBytes& bytes)
{
    TextScanner text(bytes);
    const PlyHeader header = readPlyHeader(text);
    PlyBody body(header, bytes, text);
    CloudBuilder cloud(bytes);
    for (const PlyElement& element : header.elements) {
        body.requireRows(element);
        if (element.name == "vertex") {
            readVertices(body, element, cloud);
            break; // faces do not matter
        }
        body.skip(element);
    }
    body.warnOfSurplus();
    return cloud.finish();
}

} // namespace bolster
