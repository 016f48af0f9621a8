#include "ObjFile.h"

#include "RawNumbers.h"
#include "Srgb.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace bolster {

namespace {

/// Without what ends a name in OBJ and MTL.
std::string oneWord(std::string name)
{
    for (char& c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 && !std::isalnum(byte) && c != '-' && c != '.')
            c = '_';
    }
    return name.empty() ? "_" : name;
}

template <class Numbers>
void appendNumbers(std::string& text, const char* keyword, const Numbers& numbers)
{
    text += keyword;
    for (const float number : numbers) {
        text += ' ';
        appendNumber(text, number);
    }
    text += '\n';
}

/// Of Phong's highlight, as narrow as that of the roughness (its square is GGX's alpha).
float shininess(float roughness)
{
    const float alpha = std::max(0.03F, roughness * roughness);
    return std::clamp(2 / (alpha * alpha) - 2, 1.F, 1000.F);
}

/// The older words for programs that know no more, and those for physically based materials (Pr, Pm, norm) for
/// others.
void appendMaterial(const ModelMaterial& material, const std::string& name,
                    const std::vector<std::string>& pictures, std::string& mtl)
{
    Eigen::Vector3f shown;
    for (Eigen::Index c = 0; c < 3; ++c)
        shown[c] = srgbFromLinear(std::clamp(material.color[c], 0.F, 1.F));
    mtl += "newmtl " + name + "\nillum 2\n";
    appendNumbers(mtl, "Kd", shown);
    appendNumbers(mtl, "Ks", Eigen::Vector3f::Constant(material.metallic > 0 ? 0.5F : 0.04F));
    appendNumbers(mtl, "Ns", Eigen::Matrix<float, 1, 1>(shininess(material.roughness)));
    appendNumbers(mtl, "Pr", Eigen::Matrix<float, 1, 1>(material.roughness));
    appendNumbers(mtl, "Pm", Eigen::Matrix<float, 1, 1>(material.metallic));
    const auto map = [&](const char* keyword, const std::optional<std::size_t>& picture) {
        if (!picture)
            return;
        mtl += keyword;
        if (material.repeats != Eigen::Vector2f(1, 1)) {
            appendNumbers(mtl, " -s", Eigen::Vector3f(material.repeats.x(), material.repeats.y(), 1));
            mtl.back() = ' ';
        } else {
            mtl += ' ';
        }
        mtl += pictures[*picture] + '\n';
    };
    map("map_Kd", material.colorPicture);
    map("map_Pr", material.roughPicture);
    map("norm", material.normalPicture);
    mtl += '\n';
}

void appendFaces(const ModelMesh& mesh, bool textured, std::size_t firstPoint, std::size_t firstPlace,
                 std::string& obj)
{
    for (const auto& triangle : mesh.triangles) {
        obj += 'f';
        for (const std::uint32_t corner : triangle) {
            obj += ' ';
            appendNumber(obj, firstPoint + corner);
            obj += '/';
            if (textured)
                appendNumber(obj, firstPlace + corner);
            obj += '/';
            appendNumber(obj, firstPoint + corner);
        }
        obj += '\n';
    }
}

} // namespace

ObjFiles objFiles(const CoverModel& model, const std::string& stem)
{
    const std::string base = oneWord(stem);
    ObjFiles files;
    std::vector<std::string> pictures, names;
    for (const ModelPicture& picture : model.pictures)
        pictures.push_back(base + "-" + picture.name);
    // Of other colourways OBJ knows nothing.
    std::set<std::size_t> shownMaterials, shownPictures;
    for (const ModelMesh& mesh : model.meshes)
        shownMaterials.insert(mesh.materials.front());
    std::string mtl = "# Materials by Bolster\n\n";
    for (std::size_t m = 0; m < model.materials.size(); ++m) {
        const ModelMaterial& material = model.materials[m];
        names.push_back("m" + std::to_string(m) + "_" + oneWord(material.name));
        if (!shownMaterials.contains(m))
            continue;
        appendMaterial(material, names.back(), pictures, mtl);
        for (const auto& picture : {material.colorPicture, material.roughPicture, material.normalPicture})
            if (picture)
                shownPictures.insert(*picture);
    }
    for (const std::size_t picture : shownPictures)
        files.beside.push_back({pictures[picture], model.pictures[picture].bytes});
    files.beside.push_back({base + ".mtl", mtl});

    std::string& obj = files.obj;
    obj = "# Cover by Bolster: millimetres, z up\nmtllib " + base + ".mtl\n";
    std::size_t firstPoint = 1, firstPlace = 1, group = 0;
    for (const ModelMesh& mesh : model.meshes) {
        const ModelMaterial& material = model.materials[mesh.materials.front()];
        const bool textured = material.places < mesh.places.size();
        for (const Eigen::Vector3f& p : mesh.points)
            appendNumbers(obj, "v", p);
        if (textured)
            for (const Eigen::Vector2f& p : mesh.places[material.places])
                appendNumbers(obj, "vt", p);
        for (const Eigen::Vector3f& n : mesh.normals)
            appendNumbers(obj, "vn", n);
        obj += "g g" + std::to_string(group++) + "_" + oneWord(mesh.name) + "\nusemtl " +
               names[mesh.materials.front()] + "\n";
        appendFaces(mesh, textured, firstPoint, firstPlace, obj);
        firstPoint += mesh.points.size();
        firstPlace += textured ? mesh.points.size() : 0;
    }
    return files;
}

} // namespace bolster
