// After the Khronos specifications glTF 2.0, KHR_materials_variants, KHR_texture_transform, KHR_materials_sheen.
#include "GlbFile.h"

#include "RawNumbers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace bolster {

namespace {

using Json = nlohmann::ordered_json;
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;

// Numbers of the specification.
constexpr int floatType = 5126, signedShortType = 5122, shortType = 5123, intType = 5125;
constexpr int vertexBuffer = 34962, indexBuffer = 34963;
constexpr int linear = 9729, linearMipmaps = 9987, repeat = 10497;

Json numbers(const auto& values)
{
    Json list = Json::array();
    for (const auto value : values)
        list.push_back(static_cast<double>(value) + 0.0); // no "-0"
    return list;
}

class GlbWriter {
public:
    GlbWriter(const CoverModel& model, bool small)
        : m_model(model)
        , m_small(small)
    {}

    std::string bytes();

private:
    std::size_t addView(std::size_t start, int target);
    std::size_t addAccessor(Json accessor);
    template <class Vector>
    std::size_t addVectors(const std::vector<Vector>& vectors, bool bounds);
    std::size_t addSmallNormals(const std::vector<Vec3f>& normals);
    std::size_t addIndices(const ModelMesh& mesh);
    void addPictures();
    Json textureInfo(std::size_t picture, const ModelMaterial& material);
    void addMaterial(const ModelMaterial& material);
    void addMesh(const ModelMesh& mesh);
    void addVariants(const ModelMesh& mesh, Json& primitive) const;
    void addScene();
    void use(const char* extension) { m_extensions.insert(extension); }

    const CoverModel& m_model;
    bool m_small;
    std::string m_bin;
    Json m_json;
    std::set<std::string> m_extensions;
};

std::size_t GlbWriter::addView(std::size_t start, int target)
{
    Json view{{"buffer", 0}, {"byteOffset", start}, {"byteLength", m_bin.size() - start}};
    if (target != 0)
        view["target"] = target;
    while (m_bin.size() % 4 != 0)
        m_bin += '\0';
    m_json["bufferViews"].push_back(std::move(view));
    return m_json["bufferViews"].size() - 1;
}

std::size_t GlbWriter::addAccessor(Json accessor)
{
    m_json["accessors"].push_back(std::move(accessor));
    return m_json["accessors"].size() - 1;
}

template <class Vector>
std::size_t GlbWriter::addVectors(const std::vector<Vector>& vectors, bool bounds)
{
    const std::size_t start = m_bin.size();
    Eigen::AlignedBox<float, Vector::RowsAtCompileTime> box;
    for (const Vector& v : vectors) {
        box.extend(v);
        for (const float number : v)
            appendRaw(m_bin, number + 0.0F);
    }
    Json accessor{{"bufferView", addView(start, vertexBuffer)},
                  {"componentType", floatType},
                  {"count", vectors.size()},
                  {"type", Vector::RowsAtCompileTime == 3 ? "VEC3" : "VEC2"}};
    if (bounds) {
        accessor["min"] = numbers(box.min());
        accessor["max"] = numbers(box.max());
    }
    return addAccessor(std::move(accessor));
}

/// Four numbers each, as each must begin at a multiple of 4 bytes.
std::size_t GlbWriter::addSmallNormals(const std::vector<Vec3f>& normals)
{
    const std::size_t start = m_bin.size();
    for (const Vec3f& n : normals) {
        for (const float number : n)
            appendRaw(m_bin, static_cast<std::int16_t>(std::lround(32767 * std::clamp(number, -1.F, 1.F))));
        appendRaw(m_bin, std::int16_t{0});
    }
    const std::size_t view = addView(start, vertexBuffer);
    m_json["bufferViews"][view]["byteStride"] = 8;
    use("KHR_mesh_quantization");
    return addAccessor({{"bufferView", view},
                        {"componentType", signedShortType},
                        {"normalized", true},
                        {"count", normals.size()},
                        {"type", "VEC3"}});
}

std::size_t GlbWriter::addIndices(const ModelMesh& mesh)
{
    const std::size_t start = m_bin.size();
    const bool small = mesh.points.size() < 0xFFFF; // that one would begin a new strip
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle)
            if (small)
                appendRaw(m_bin, static_cast<std::uint16_t>(index));
            else
                appendRaw(m_bin, index);
    return addAccessor({{"bufferView", addView(start, indexBuffer)},
                        {"componentType", small ? shortType : intType},
                        {"count", 3 * mesh.triangles.size()},
                        {"type", "SCALAR"}});
}

void GlbWriter::addPictures()
{
    if (m_model.pictures.empty())
        return;
    m_json["samplers"] =
        Json::array({{{"magFilter", linear}, {"minFilter", linearMipmaps}, {"wrapS", repeat}, {"wrapT", repeat}}});
    for (const ModelPicture& picture : m_model.pictures) {
        const std::size_t start = m_bin.size();
        m_bin += picture.bytes;
        const std::size_t view = addView(start, 0); // first: new members move what was referred to
        m_json["images"].push_back({{"name", picture.name},
                                    {"bufferView", view},
                                    {"mimeType", picture.jpeg ? "image/jpeg" : "image/png"}});
        m_json["textures"].push_back({{"sampler", 0}, {"source", m_json["images"].size() - 1}});
    }
}

Json GlbWriter::textureInfo(std::size_t picture, const ModelMaterial& material)
{
    Json info{{"index", picture}};
    if (material.places != 0)
        info["texCoord"] = material.places;
    if (material.repeats != Vec2f(1, 1)) {
        info["extensions"]["KHR_texture_transform"]["scale"] = numbers(material.repeats);
        use("KHR_texture_transform");
    }
    return info;
}

void GlbWriter::addMaterial(const ModelMaterial& material)
{
    Json surface{{"baseColorFactor", numbers(material.color)},
                 {"metallicFactor", material.metallic},
                 {"roughnessFactor", material.roughness}};
    surface["baseColorFactor"].push_back(1.0);
    if (material.colorPicture)
        surface["baseColorTexture"] = textureInfo(*material.colorPicture, material);
    if (material.roughPicture)
        surface["metallicRoughnessTexture"] = textureInfo(*material.roughPicture, material);
    Json json{{"name", material.name}, {"pbrMetallicRoughness", std::move(surface)}, {"doubleSided", true}};
    if (material.normalPicture)
        json["normalTexture"] = textureInfo(*material.normalPicture, material);
    if (material.sheen > 0) {
        // What fibres scatter in studio.glsl is white by a quarter, else of their colour.
        const Vec3f sheen = material.sheen * (0.75F * material.mean + Vec3f::Constant(0.25F));
        json["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", numbers(sheen.cwiseMin(1.F).eval())},
                                                     {"sheenRoughnessFactor", 0.5}};
        use("KHR_materials_sheen");
    }
    m_json["materials"].push_back(std::move(json));
}

/// Which material is whose colourway's.
void GlbWriter::addVariants(const ModelMesh& mesh, Json& primitive) const
{
    Json mappings = Json::array();
    for (std::size_t variant = 0; variant < mesh.materials.size(); ++variant) {
        const std::size_t material = mesh.materials[variant];
        auto same = std::find_if(mappings.begin(), mappings.end(),
                                 [&](const Json& mapping) { return mapping["material"] == material; });
        if (same != mappings.end())
            (*same)["variants"].push_back(variant);
        else
            mappings.push_back({{"material", material}, {"variants", Json::array({variant})}});
    }
    primitive["extensions"]["KHR_materials_variants"]["mappings"] = std::move(mappings);
}

void GlbWriter::addMesh(const ModelMesh& mesh)
{
    std::vector<Vec3f> points, normals;
    for (const Vec3f& p : mesh.points)
        points.push_back(metresYUp(p));
    for (const Vec3f& n : mesh.normals)
        normals.push_back(yUp(n));
    Json primitive;
    primitive["attributes"]["POSITION"] = addVectors(points, true);
    primitive["attributes"]["NORMAL"] = m_small ? addSmallNormals(normals) : addVectors(normals, false);
    for (std::size_t set = 0; set < mesh.places.size(); ++set) {
        std::vector<Vec2f> places;
        for (const Vec2f& p : mesh.places[set])
            places.emplace_back(p.x(), -p.y()); // from the top down: tiles repeat, so nothing need be added
        primitive["attributes"]["TEXCOORD_" + std::to_string(set)] = addVectors(places, false);
    }
    primitive["indices"] = addIndices(mesh);
    primitive["material"] = mesh.materials.front();
    if (m_model.colourways.size() > 1)
        addVariants(mesh, primitive);
    static constexpr const char* kinds[] = {"patch", "trim", "seam", "frame"};
    m_json["meshes"].push_back({{"name", mesh.name},
                                {"primitives", Json::array({std::move(primitive)})},
                                {"extras", {{"kind", kinds[static_cast<int>(mesh.kind)]}}}});
    m_json["nodes"].push_back({{"name", mesh.name}, {"mesh", m_json["meshes"].size() - 1}});
}

void GlbWriter::addScene()
{
    Json children = Json::array();
    for (std::size_t node = 0; node < m_json["nodes"].size(); ++node)
        children.push_back(node);
    const double half = -m_model.front / 2;
    Json root{{"name", "Cover"}, {"children", std::move(children)}};
    if (m_model.front != 0)
        root["rotation"] = numbers(std::array{0.0, std::sin(half), 0.0, std::cos(half)});
    root["translation"] = numbers(standing(m_model));
    m_json["nodes"].push_back(std::move(root));
    m_json["scenes"] = Json::array({{{"nodes", Json::array({m_json["nodes"].size() - 1})}}});
    m_json["scene"] = 0;
}

std::string GlbWriter::bytes()
{
    m_json["asset"] = {{"version", "2.0"}, {"generator", "Bolster"}};
    m_json["extensionsUsed"] = Json::array();
    addPictures();
    for (const ModelMaterial& material : m_model.materials)
        addMaterial(material);
    for (const ModelMesh& mesh : m_model.meshes)
        addMesh(mesh);
    addScene();
    if (m_model.colourways.size() > 1) {
        use("KHR_materials_variants");
        for (const std::string& name : m_model.colourways)
            m_json["extensions"]["KHR_materials_variants"]["variants"].push_back({{"name", name}});
    }
    if (m_extensions.empty())
        m_json.erase("extensionsUsed");
    else
        m_json["extensionsUsed"] = m_extensions;
    if (m_small)
        m_json["extensionsRequired"] = Json::array({"KHR_mesh_quantization"});
    m_json["buffers"] = Json::array({{{"byteLength", m_bin.size()}}});

    std::string json = m_json.dump(-1, ' ', false, Json::error_handler_t::replace);
    while (json.size() % 4 != 0)
        json += ' ';
    constexpr std::size_t heads = 12 + 8 + 8;
    if (json.size() + m_bin.size() + heads > 0xFFFFFFFFU)
        throw std::runtime_error("more than 4 GB");
    std::string file = "glTF";
    appendRaw(file, std::uint32_t{2});
    appendRaw(file, static_cast<std::uint32_t>(heads + json.size() + m_bin.size()));
    appendRaw(file, static_cast<std::uint32_t>(json.size()));
    file += "JSON" + json;
    appendRaw(file, static_cast<std::uint32_t>(m_bin.size()));
    file.append("BIN\0", 4);
    return file + m_bin;
}

} // namespace

Eigen::Vector3f yUp(const Eigen::Vector3f& p)
{
    return {p.x(), p.z(), -p.y()};
}

Eigen::Vector3f metresYUp(const Eigen::Vector3f& p)
{
    return yUp(p) / 1000;
}

Eigen::Vector3f standing(const CoverModel& model)
{
    if (model.box.isEmpty())
        return Vec3f::Zero();
    Vec3f foot = metresYUp(model.box.center());
    foot.y() = model.box.min().z() / 1000;
    const Eigen::AngleAxisf turn(static_cast<float>(-model.front), Vec3f::UnitY());
    return -(turn * foot);
}

std::string glbFile(const CoverModel& model, bool small)
{
    return GlbWriter(model, small).bytes();
}

} // namespace bolster
