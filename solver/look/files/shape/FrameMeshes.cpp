#include "FrameMeshes.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace bolster {

Eigen::Vector3f unitOr(const Eigen::Vector3f& normal, const Eigen::Vector3f& other)
{
    return normal.allFinite() && normal.squaredNorm() > 0.25F ? Eigen::Vector3f(normal.normalized()) : other;
}

namespace {

/// Points of corners, each once.
class CornerPoints {
public:
    CornerPoints(ModelMesh& mesh, const std::function<bool(const Eigen::Vector3f&)>& hidden)
        : m_mesh(mesh)
        , m_hidden(hidden)
    {}

    bool isHidden(const Eigen::Vector3f& p)
    {
        const auto [at, isNew] = m_isHidden.try_emplace(std::tuple(p.x(), p.y(), p.z()), false);
        if (isNew)
            at->second = m_hidden(p);
        return at->second;
    }
    std::uint32_t operator()(const FrameSkin::Corner& corner)
    {
        const Eigen::Vector3f &p = corner.position, n = unitOr(corner.normal, Eigen::Vector3f::UnitZ());
        const auto [at, isNew] = m_known.try_emplace(std::tuple(p.x(), p.y(), p.z(), n.x(), n.y(), n.z()),
                                                     static_cast<std::uint32_t>(m_mesh.points.size()));
        if (isNew) {
            m_mesh.points.push_back(p);
            m_mesh.normals.push_back(n);
        }
        return at->second;
    }

private:
    ModelMesh& m_mesh;
    const std::function<bool(const Eigen::Vector3f&)>& m_hidden;
    std::map<std::tuple<float, float, float>, bool> m_isHidden;
    std::map<std::tuple<float, float, float, float, float, float>, std::uint32_t> m_known;
};

} // namespace

ModelMesh frameMesh(const FrameSkin& skin, const std::function<bool(const Eigen::Vector3f&)>& hidden)
{
    ModelMesh mesh;
    mesh.kind = ModelMesh::Kind::Frame;
    CornerPoints points(mesh, hidden);
    for (std::size_t c = 0; c + 2 < skin.corners.size(); c += 3) {
        const std::array corners{&skin.corners[c], &skin.corners[c + 1], &skin.corners[c + 2]};
        const auto known = [](const FrameSkin::Corner* corner) { return corner->position.allFinite(); };
        const auto unseen = [&](const FrameSkin::Corner* corner) { return points.isHidden(corner->position); };
        if (std::ranges::all_of(corners, known) && !std::ranges::all_of(corners, unseen))
            mesh.triangles.push_back({points(*corners[0]), points(*corners[1]), points(*corners[2])});
    }
    return mesh;
}

} // namespace bolster
