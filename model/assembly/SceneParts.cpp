#include "SceneParts.h"

#include "PartMesh.h"

#include <assimp/scene.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace bolster {
namespace {

using Matrix = Eigen::Matrix4d;

constexpr std::size_t deepest = 1000;

std::uint32_t packed(const aiColor4D& color, bool linear)
{
    std::uint32_t all = 0;
    for (float share : {color.r, color.g, color.b}) {
        share = std::isfinite(share) ? std::clamp(share, 0.F, 1.F) : 0.F;
        if (linear)
            share = share <= 0.0031308F ? 12.92F * share : 1.055F * std::pow(share, 1 / 2.4F) - 0.055F;
        all = all << 8 | static_cast<std::uint32_t>(std::lround(255 * share));
    }
    return all;
}

class SceneParts {
public:
    using Names = std::map<std::string, std::string, std::less<>>;

    SceneParts(const aiScene& scene, const SceneOrder& order, const Names& names, AssemblyWriter& writer)
        : m_scene(scene)
        , m_ending(order.ending)
        , m_names(names)
        , m_writer(writer)
    {}

    /// Without recursion: a tree may be as deep as the file is long.
    void write()
    {
        std::vector<Place> open = {{m_scene.mRootNode, Matrix::Identity(), {}, 0}};
        std::size_t nodes = 0;
        while (!open.empty()) {
            const Place place = open.back();
            open.pop_back();
            if (place.depth > deepest) {
                ++m_tooDeep;
                continue;
            }
            const Matrix here = place.above * matrixOf(place.node->mTransformation);
            const auto part =
                isBare(*place.node) ? std::nullopt : std::optional(addNode(*place.node, here, place.parent));
            m_writer.progress(1 - (1 - shareOfSceneReading) / std::sqrt(static_cast<double>(++nodes)));
            for (unsigned i = place.node->mNumChildren; i-- > 0;)
                open.push_back({place.node->mChildren[i], here, part, place.depth + 1});
        }
        if (m_notFinite > 0)
            m_writer.warn(AssemblyOddity::NotFinite, m_notFinite);
        if (m_noPoint > 0)
            m_writer.warn(AssemblyOddity::NoPoint, m_noPoint);
        if (m_noSize > 0)
            m_writer.warn(AssemblyOddity::NoSize, m_noSize, m_firstWithoutSize);
        if (m_tooDeep > 0)
            m_writer.warn(AssemblyOddity::TooDeep, m_tooDeep);
    }

private:
    struct Place {
        const aiNode* node;
        Matrix above;
        std::optional<std::uint32_t> parent;
        std::size_t depth;
    };

    /// The root that is there in every file of the format says nothing.
    bool isBare(const aiNode& node) const
    {
        const bool everywhere = m_ending == "fbx" || m_ending == "3mf" || m_ending == "dae";
        return &node == m_scene.mRootNode && node.mNumMeshes == 0 &&
               (everywhere || std::string_view(node.mName.C_Str()) == "ROOT");
    }

    std::uint32_t addNode(const aiNode& node, const Matrix& here, std::optional<std::uint32_t> parent)
    {
        const std::string name = nameOf(node);
        const std::uint32_t part = m_writer.addPart(name, parent, colorOf(node));
        if (node.mNumMeshes == 0)
            return part;
        const double volume = here.topLeftCorner<3, 3>().determinant();
        if (!here.allFinite() || volume == 0) {
            if (m_noSize++ == 0)
                m_firstWithoutSize = name;
            return part;
        }
        PartMesh mesh;
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            if (node.mMeshes[i] < m_scene.mNumMeshes)
                addMesh(*m_scene.mMeshes[node.mMeshes[i]], here, volume < 0, name, mesh);
        m_notFinite += mesh.leftOut();
        mesh.send(m_writer, part);
        return part;
    }

    std::string nameOf(const aiNode& node) const
    {
        std::string name = node.mName.C_Str();
        constexpr std::string_view ofGroups = "Object_"; // how the library begins theirs
        const std::string_view number =
            std::string_view(name).substr(name.starts_with(ofGroups) ? ofGroups.size() : 0);
        if (const auto given = m_names.find(number); given != m_names.end())
            return given->second;
        if (name.empty() && node.mNumMeshes > 0 && node.mMeshes[0] < m_scene.mNumMeshes)
            if (const char* const ofMesh = m_scene.mMeshes[node.mMeshes[0]]->mName.C_Str(); *ofMesh != '\0')
                name = ofMesh;
        return name;
    }

    void addMesh(const aiMesh& mesh, const Matrix& here, bool mirrored, const std::string& name, PartMesh& part)
    {
        m_points.clear();
        for (unsigned i = 0; i < mesh.mNumVertices && mesh.mVertices; ++i) {
            const aiVector3D& at = mesh.mVertices[i];
            const Vec3 point(static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z));
            m_points.push_back(part.addPoint((here * point.homogeneous()).head<3>(), name));
        }
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            m_corners.clear();
            for (unsigned corner = 0; corner < face.mNumIndices; ++corner)
                if (face.mIndices[corner] < m_points.size())
                    m_corners.push_back(m_points[face.mIndices[corner]]);
            if (m_corners.size() != face.mNumIndices)
                ++m_noPoint;
            if (m_corners.size() < 3 || m_corners.size() != face.mNumIndices) // lines and points are no frame
                continue;
            if (mirrored)
                std::ranges::reverse(m_corners);
            part.addFace(m_corners);
        }
    }

    std::optional<std::uint32_t> colorOf(const aiNode& node) const
    {
        if (node.mNumMeshes == 0 || node.mMeshes[0] >= m_scene.mNumMeshes)
            return {};
        const unsigned index = m_scene.mMeshes[node.mMeshes[0]]->mMaterialIndex;
        aiColor4D color;
        if (index >= m_scene.mNumMaterials ||
            m_scene.mMaterials[index]->GetName() == aiString(AI_DEFAULT_MATERIAL_NAME) ||
            (m_scene.mMaterials[index]->Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS &&
             m_scene.mMaterials[index]->Get(AI_MATKEY_COLOR_DIFFUSE, color) != aiReturn_SUCCESS))
            return {};
        return packed(color, m_ending == "glb" || m_ending == "gltf");
    }

    const aiScene& m_scene;
    const std::string& m_ending;
    const Names& m_names;
    AssemblyWriter& m_writer;
    std::vector<std::int64_t> m_points;  // scratch
    std::vector<std::int64_t> m_corners; // scratch
    std::uint64_t m_notFinite = 0;
    std::uint64_t m_noPoint = 0;
    std::uint64_t m_noSize = 0;
    std::uint64_t m_tooDeep = 0;
    std::string m_firstWithoutSize;
};

} // namespace

Eigen::Matrix4d matrixOf(const aiMatrix4x4& m)
{
    Matrix matrix;
    matrix << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
    return matrix;
}

void writeSceneParts(const aiScene& scene, const SceneOrder& order,
                     const std::map<std::string, std::string, std::less<>>& names, AssemblyWriter& writer)
{
    SceneParts(scene, order, names, writer).write();
}

} // namespace bolster
