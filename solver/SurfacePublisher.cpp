#include "SurfacePublisher.h"

namespace bolster {

SurfaceMeshPtr makeSurface(const SewnMesh& mesh, const SheetState& state, std::uint64_t revision)
{
    auto surface = std::make_shared<SurfaceMesh>();
    surface->topology = mesh.topology;
    surface->revision = revision;
    surface->positions.resize(mesh.vertexCount());
    for (int v = 0; v < mesh.vertexCount(); ++v)
        surface->positions[v] = state.positions.col(mesh.topology->unknown[v]);
    surface->normals.assign(mesh.vertexCount(), Eigen::Vector3f::Zero());
    for (const auto& [a, b, c] : mesh.topology->triangles) {
        const auto& p = surface->positions;
        const Eigen::Vector3f normal = (p[b] - p[a]).cross(p[c] - p[a]).cast<float>(); // weighted by area
        surface->normals[a] += normal;
        surface->normals[b] += normal;
        surface->normals[c] += normal;
    }
    for (Eigen::Vector3f& normal : surface->normals)
        normal = normal.squaredNorm() > 0 ? normal.normalized() : Eigen::Vector3f(Eigen::Vector3f::UnitZ());
    return surface;
}

} // namespace bolster
