#include "FrameMeshes.h"

#include <map>
#include <tuple>

namespace bolster {

Eigen::Vector3f unitOr(const Eigen::Vector3f& normal, const Eigen::Vector3f& other)
{
    return normal.allFinite() && normal.squaredNorm() > 0.25F ? Eigen::Vector3f(normal.normalized()) : other;
}

ModelMesh frameMesh(const FrameSkin& skin)
{
    ModelMesh mesh;
    mesh.kind = ModelMesh::Kind::Frame;
    std::map<std::tuple<float, float, float, float, float, float>, std::uint32_t> known;
    for (std::size_t c = 0; c + 2 < skin.corners.size(); c += 3) {
        std::array<std::uint32_t, 3> corners{};
        bool whole = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const FrameSkin::Corner& corner = skin.corners[c + i];
            const Eigen::Vector3f &p = corner.position, n = unitOr(corner.normal, Eigen::Vector3f::UnitZ());
            whole = whole && p.allFinite();
            if (!whole)
                break;
            const auto [at, isNew] = known.try_emplace(std::tuple(p.x(), p.y(), p.z(), n.x(), n.y(), n.z()),
                                                       static_cast<std::uint32_t>(mesh.points.size()));
            corners[i] = at->second;
            if (isNew) {
                mesh.points.push_back(p);
                mesh.normals.push_back(n);
            }
        }
        if (whole)
            mesh.triangles.push_back(corners);
    }
    return mesh;
}

} // namespace bolster
