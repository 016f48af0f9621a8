#include "SolidFile.h"

#include "PackedFile.h"
#include "RawNumbers.h"

#include <map>

namespace bolster {

namespace {

constexpr const char* contentTypes = R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* relations = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

/// A part with points of its own.
void appendObject(const TriangleMesh& solid, const TriangleMesh::Part& part, std::size_t id, std::string& xml)
{
    std::map<std::uint32_t, std::uint32_t> known;
    std::string points, triangles;
    for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
        triangles += "<triangle";
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [at, isNew] =
                known.try_emplace(solid.triangles[t][i], static_cast<std::uint32_t>(known.size()));
            triangles += std::string(" v") + static_cast<char>('1' + i) + "=\"" + std::to_string(at->second) + "\"";
            if (!isNew)
                continue;
            points += "<vertex";
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                points += std::string(" ") + "xyz"[axis] + "=\"";
                appendNumber(points, static_cast<float>(solid.points[solid.triangles[t][i]][axis]));
                points += '"';
            }
            points += "/>\n";
        }
        triangles += "/>\n";
    }
    xml += "<object id=\"" + std::to_string(id) + "\" type=\"model\" name=\"" + part.name +
           "\"><mesh>\n<vertices>\n" + points + "</vertices>\n<triangles>\n" + triangles +
           "</triangles>\n</mesh></object>\n";
}

} // namespace

std::string stlFile(const TriangleMesh& solid)
{
    std::string bytes = "STL, millimetres, by Bolster";
    bytes.resize(80, ' ');
    appendRaw(bytes, static_cast<std::uint32_t>(solid.triangles.size()));
    for (const auto& t : solid.triangles) {
        const Vec3 &a = solid.points[t[0]], &b = solid.points[t[1]], &c = solid.points[t[2]];
        const Vec3 normal = (b - a).cross(c - a).normalized();
        for (const Vec3* v : {&normal, &a, &b, &c})
            for (const double number : *v)
                appendRaw(bytes, static_cast<float>(number) + 0.0F);
        appendRaw(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string threeMfFile(const TriangleMesh& solid)
{
    std::string xml = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Bolster</metadata>
<resources>
)";
    std::string items;
    for (std::size_t part = 0; part < solid.parts.size(); ++part) {
        appendObject(solid, solid.parts[part], part + 1, xml);
        items += "<item objectid=\"" + std::to_string(part + 1) + "\"/>\n";
    }
    xml += "</resources>\n<build>\n" + items + "</build>\n</model>\n";
    PackedFile file;
    file.add("[Content_Types].xml", contentTypes, true);
    file.add("_rels/.rels", relations, true);
    file.add("3D/3dmodel.model", xml, true);
    return std::move(file).bytes();
}

} // namespace bolster
