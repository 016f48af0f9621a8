#include "MadeScenes.h"

#include <cstdint>
#include <cstring>
#include <sstream>

namespace bolster::test {
namespace {

/// Counter-clockwise from outside; corner i is at x = i & 1, y = i >> 1 & 1, z = i >> 2.
constexpr std::uint16_t cubeTriangles[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                           2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

template <class Number>
void append(std::string& bytes, const Number& number)
{
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string words(int from, int to)
{
    std::ostringstream text;
    for (int i = 0; i < 8; ++i)
        text << ((i & 1) != 0 ? to : from) << ' ' << ((i >> 1 & 1) != 0 ? to : from) << ' '
             << (i >> 2 != 0 ? to : from) << ' ';
    return text.str();
}

} // namespace

std::vector<float> GltfScene::cubePoints()
{
    std::vector<float> points;
    for (int i = 0; i < 8; ++i)
        for (const int side : {i & 1, i >> 1 & 1, i >> 2})
            points.push_back(side != 0 ? 1.F : -1.F);
    return points;
}

std::string gltfBuffer(const GltfScene& scene)
{
    std::string bytes;
    for (const float coordinate : scene.points)
        append(bytes, coordinate);
    for (const std::uint16_t corner : cubeTriangles)
        append(bytes, corner);
    return bytes;
}

std::string gltfText(const GltfScene& scene)
{
    const std::size_t points = 4 * scene.points.size(), triangles = sizeof cubeTriangles;
    std::ostringstream text;
    text << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": )" << scene.roots << R"(}],
        "nodes": )"
         << scene.nodes << R"(,
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.2158605, 0, 1]}}],
        "meshes": [{"name": "Shape", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": )"
         << scene.points.size() / 3 << R"(, "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": )"
         << points << R"(},
            {"buffer": 0, "byteOffset": )"
         << points << R"(, "byteLength": )" << triangles << R"(}],
        "buffers": [{)";
    if (!scene.uri.empty())
        text << R"("uri": ")" << scene.uri << R"(", )";
    text << R"("byteLength": )" << points + triangles << "}]}";
    return text.str();
}

std::string glbBytes(const GltfScene& scene)
{
    std::string text = gltfText(scene), buffer = gltfBuffer(scene), bytes = "glTF";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    append(bytes, std::uint32_t{2});
    append(bytes, static_cast<std::uint32_t>(28 + text.size() + buffer.size()));
    append(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += "JSON" + text;
    append(bytes, static_cast<std::uint32_t>(buffer.size()));
    bytes += std::string("BIN\0", 4) + buffer;
    return bytes;
}

std::string fbxText(double factor, int up)
{
    std::ostringstream text;
    text << "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7400\n}\n"
            "GlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n"
            "\t\tP: \"UpAxis\", \"int\", \"Integer\", \"\","
         << up
         << "\n\t\tP: \"UpAxisSign\", \"int\", \"Integer\", \"\",1\n"
            "\t\tP: \"FrontAxis\", \"int\", \"Integer\", \"\","
         << 3 - up
         << "\n\t\tP: \"FrontAxisSign\", \"int\", \"Integer\", \"\",1\n"
            "\t\tP: \"CoordAxis\", \"int\", \"Integer\", \"\",0\n"
            "\t\tP: \"CoordAxisSign\", \"int\", \"Integer\", \"\",1\n"
            "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\","
         << factor
         << "\n\t}\n}\nObjects:  {\n\tGeometry: 1, \"Geometry::Box\", \"Mesh\" {\n\t\tVertices: *24 {\n\t\t\ta: ";
    std::istringstream corners(words(0, 10));
    std::string word, separator;
    while (corners >> word) {
        text << separator << word;
        separator = ",";
    }
    text << "\n\t\t}\n\t\tPolygonVertexIndex: *36 {\n\t\t\ta: ";
    for (std::size_t i = 0; i < 36; ++i) // the last corner of a polygon is written as its complement
        text << (i > 0 ? "," : "") << (i % 3 == 2 ? -1 - cubeTriangles[i] : cubeTriangles[i]);
    text << "\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n"
            "\tModel: 2, \"Model::Group\", \"Null\" {\n\t\tVersion: 232\n\t}\n"
            "\tModel: 3, \"Model::Box\", \"Mesh\" {\n\t\tVersion: 232\n\t\tProperties70:  {\n"
            "\t\t\tP: \"Lcl Translation\", \"Lcl Translation\", \"\", \"A\",100,0,0\n\t\t}\n\t}\n}\n"
            "Connections:  {\n\tC: \"OO\",2,0\n\tC: \"OO\",3,2\n\tC: \"OO\",1,3\n}\n";
    return text.str();
}

std::string colladaText(const std::string& unit, const std::string& up, const std::string& nodes,
                        const std::string& library)
{
    std::ostringstream text;
    text << R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>)" << unit
         << up << R"(</asset>
<library_geometries><geometry id="g" name="Shape"><mesh>
<source id="p"><float_array id="a" count="24">)"
         << words(0, 10) << R"(</float_array>
<technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>)";
    for (const std::uint16_t corner : cubeTriangles)
        text << corner << ' ';
    text << "</p></triangles></mesh></geometry></library_geometries>\n";
    if (!library.empty())
        text << "<library_nodes>" << library << "</library_nodes>\n";
    text << R"(<library_visual_scenes><visual_scene id="s">)"
         << (nodes.empty() ? R"(<node id="n" name="Box"><instance_geometry url="#g"/></node>)" : nodes)
         << R"(</visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
    return text.str();
}

} // namespace bolster::test
