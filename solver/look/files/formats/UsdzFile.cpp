// After the USDZ file format specification and the UsdPreviewSurface proposal of Pixar's OpenUSD documents.
#include "UsdzFile.h"

#include "GlbFile.h"
#include "PackedFile.h"
#include "RawNumbers.h"

#include <algorithm>
#include <cctype>
#include <numbers>

namespace bolster {

namespace {

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;

/// (1, 2, 3)
template <class Vector>
void appendTuple(std::string& text, const Vector& vector)
{
    const char* before = "(";
    for (const float number : vector) {
        text += before;
        appendNumber(text, number);
        before = ", ";
    }
    text += ')';
}

template <class Values, class Append>
std::string listOf(const Values& values, const Append& append)
{
    std::string text = "[";
    for (const auto& value : values) {
        if (text.size() > 1)
            text += ", ";
        append(text, value);
    }
    return text + "]";
}

std::string vectors(const std::vector<Vec3f>& values, Vec3f (*turned)(const Vec3f&))
{
    return listOf(values, [&](std::string& text, const Vec3f& v) { appendTuple(text, turned(v)); });
}

std::string tuple(const auto& vector)
{
    std::string text;
    appendTuple(text, vector);
    return text;
}

std::string numberOf(float value)
{
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string inQuotes(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text)
        if (c == '"' || c == '\\')
            quoted += {'\\', c};
        else if (static_cast<unsigned char>(c) >= ' ')
            quoted += c;
    return quoted + "\"";
}

/// As names of variants may be: letters, digits, "_"; no two alike.
std::vector<std::string> variantNames(const std::vector<std::string>& colourways)
{
    std::vector<std::string> names;
    for (const std::string& colourway : colourways) {
        std::string name;
        for (const char c : colourway)
            name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
        if (name.empty() || std::ranges::count(names, name) > 0)
            name += "_" + std::to_string(names.size() + 1);
        names.push_back(name);
    }
    return names;
}

const char* setName(std::size_t set)
{
    static constexpr const char* names[] = {"st", "st1", "st2", "st3", "st4", "st5", "st6", "st7"};
    return names[std::min(set, std::size(names) - 1)];
}

class UsdWriter {
public:
    explicit UsdWriter(const CoverModel& model)
        : m_model(model)
    {}

    std::string text();

private:
    void line(int depth, const std::string& text)
    {
        m_text.append(4 * static_cast<std::size_t>(depth), ' ') += text + "\n";
    }
    void addMaterial(std::size_t index);
    void addTexture(const std::string& material, const char* name, std::size_t picture, bool color, bool normal);
    void addMesh(std::size_t index);
    void addVariants();
    std::string bound(std::size_t material) const
    {
        return "rel material:binding = </Cover/Materials/m" + std::to_string(material) + ">";
    }

    const CoverModel& m_model;
    std::string m_text;
};

void UsdWriter::addTexture(const std::string& material, const char* name, std::size_t picture, bool color,
                           bool normal)
{
    line(3, std::string("def Shader \"") + name + "\"");
    line(3, "{");
    line(4, "uniform token info:id = \"UsdUVTexture\"");
    line(4, "asset inputs:file = @textures/" + m_model.pictures[picture].name + "@");
    line(4, "float2 inputs:st.connect = <" + material + "/Tile.outputs:result>");
    line(4, std::string("token inputs:sourceColorSpace = ") + (color ? "\"sRGB\"" : "\"raw\""));
    line(4, "token inputs:wrapS = \"repeat\"");
    line(4, "token inputs:wrapT = \"repeat\"");
    if (normal) {
        line(4, "float4 inputs:scale = (2, 2, 2, 1)");
        line(4, "float4 inputs:bias = (-1, -1, -1, 0)");
    }
    line(4, "float outputs:r");
    line(4, "float3 outputs:rgb");
    line(3, "}");
}

void UsdWriter::addMaterial(std::size_t index)
{
    const ModelMaterial& material = m_model.materials[index];
    const std::string path = "/Cover/Materials/m" + std::to_string(index);
    line(2, "def Material \"m" + std::to_string(index) + "\" (displayName = " + inQuotes(material.name) + ")");
    line(2, "{");
    line(3, "token outputs:surface.connect = <" + path + "/Surface.outputs:surface>");
    line(3, "def Shader \"Surface\"");
    line(3, "{");
    line(4, "uniform token info:id = \"UsdPreviewSurface\"");
    line(4, material.colorPicture ? "color3f inputs:diffuseColor.connect = <" + path + "/Color.outputs:rgb>"
                                  : "color3f inputs:diffuseColor = " + tuple(material.color));
    line(4, material.roughPicture ? "float inputs:roughness.connect = <" + path + "/Roughness.outputs:r>"
                                  : "float inputs:roughness = " + numberOf(material.roughness));
    line(4, "float inputs:metallic = " + numberOf(material.metallic));
    if (material.normalPicture)
        line(4, "normal3f inputs:normal.connect = <" + path + "/Normal.outputs:rgb>");
    line(4, "token outputs:surface");
    line(3, "}");
    if (material.colorPicture) {
        line(3, "def Shader \"Places\"");
        line(3, "{");
        line(4, "uniform token info:id = \"UsdPrimvarReader_float2\"");
        line(4, std::string("string inputs:varname = \"") + setName(material.places) + "\"");
        line(4, "float2 outputs:result");
        line(3, "}");
        line(3, "def Shader \"Tile\"");
        line(3, "{");
        line(4, "uniform token info:id = \"UsdTransform2d\"");
        line(4, "float2 inputs:in.connect = <" + path + "/Places.outputs:result>");
        line(4, "float2 inputs:scale = " + tuple(material.repeats));
        line(4, "float2 outputs:result");
        line(3, "}");
        addTexture(path, "Color", *material.colorPicture, true, false);
        if (material.roughPicture)
            addTexture(path, "Roughness", *material.roughPicture, false, false);
        if (material.normalPicture)
            addTexture(path, "Normal", *material.normalPicture, false, true);
    }
    line(2, "}");
}

void UsdWriter::addMesh(std::size_t index)
{
    const ModelMesh& mesh = m_model.meshes[index];
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : mesh.points)
        box.extend(metresYUp(p));
    line(1, "def Mesh \"Mesh_" + std::to_string(index) + "\" (");
    line(2, "displayName = " + inQuotes(mesh.name));
    line(2, "prepend apiSchemas = [\"MaterialBindingAPI\"]");
    line(1, ")");
    line(1, "{");
    line(2, "uniform bool doubleSided = 1");
    line(2, "uniform token subdivisionScheme = \"none\"");
    line(2, "float3[] extent = [" + tuple(box.min()) + ", " + tuple(box.max()) + "]");
    line(2,
         "int[] faceVertexCounts = " + listOf(mesh.triangles, [](std::string& text, const auto&) { text += '3'; }));
    line(2, "int[] faceVertexIndices = " + listOf(mesh.triangles, [](std::string& text, const auto& t) {
                text += std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " + std::to_string(t[2]);
            }));
    line(2, "point3f[] points = " + vectors(mesh.points, metresYUp));
    line(2, "normal3f[] normals = " + vectors(mesh.normals, yUp) + " (interpolation = \"vertex\")");
    for (std::size_t set = 0; set < mesh.places.size(); ++set)
        line(2, std::string("texCoord2f[] primvars:") + setName(set) + " = " +
                    listOf(mesh.places[set], appendTuple<Vec2f>) + " (interpolation = \"vertex\")");
    if (m_model.colourways.size() == 1) // else the variants say it: what is said here would outweigh them
        line(2, bound(mesh.materials.front()));
    line(1, "}");
}

void UsdWriter::addVariants()
{
    const std::vector<std::string> names = variantNames(m_model.colourways);
    line(1, "variantSet \"colourway\" = {");
    for (std::size_t variant = 0; variant < names.size(); ++variant) {
        line(2, "\"" + names[variant] + "\" {");
        for (std::size_t mesh = 0; mesh < m_model.meshes.size(); ++mesh) {
            line(3, "over \"Mesh_" + std::to_string(mesh) + "\"");
            line(3, "{");
            line(4, bound(m_model.meshes[mesh].materials[variant]));
            line(3, "}");
        }
        line(2, "}");
    }
    line(1, "}");
}

std::string UsdWriter::text()
{
    const bool variants = m_model.colourways.size() > 1;
    line(0, "#usda 1.0");
    line(0, "(");
    line(1, "defaultPrim = \"Cover\"");
    line(1, "doc = \"Cover by Bolster\"");
    line(1, "metersPerUnit = 1");
    line(1, "upAxis = \"Y\"");
    line(0, ")");
    line(0, "");
    line(0, "def Xform \"Cover\" (");
    line(1, "kind = \"component\"");
    if (variants) {
        line(1, "variants = { string colourway = \"" + variantNames(m_model.colourways).front() + "\" }");
        line(1, "prepend variantSets = \"colourway\"");
    }
    line(0, ")");
    line(0, "{");
    line(1, "double3 xformOp:translate = " + tuple(standing(m_model)));
    line(1, "float xformOp:rotateY = " + numberOf(static_cast<float>(-m_model.front * 180 / std::numbers::pi)));
    line(1, "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateY\"]");
    line(1, "def Scope \"Materials\"");
    line(1, "{");
    for (std::size_t material = 0; material < m_model.materials.size(); ++material)
        addMaterial(material);
    line(1, "}");
    for (std::size_t mesh = 0; mesh < m_model.meshes.size(); ++mesh)
        addMesh(mesh);
    if (variants)
        addVariants();
    line(0, "}");
    return std::move(m_text);
}

} // namespace

std::string usdText(const CoverModel& model)
{
    return UsdWriter(model).text();
}

std::string usdzFile(const CoverModel& model)
{
    constexpr std::uint32_t alignment = 64; // so that readers can use contents where they lie
    PackedFile file(alignment);
    file.add("cover.usda", usdText(model), false);
    for (const ModelPicture& picture : model.pictures)
        file.add("textures/" + picture.name, picture.bytes, false);
    return std::move(file).bytes();
}

} // namespace bolster
