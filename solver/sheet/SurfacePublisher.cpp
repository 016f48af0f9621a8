#include "SurfacePublisher.h"

#include "Relief.h"

namespace bolster {

SurfaceMeshPtr makeSurface(const SewnMesh& mesh, const SheetState& state, std::uint64_t revision)
{
    auto surface = std::make_shared<SurfaceMesh>();
    surface->topology = mesh.topology;
    surface->revision = revision;
    surface->positions = coverPositions(mesh, state);
    surface->normals = smoothNormals(*mesh.topology, surface->positions);
    return surface;
}

} // namespace bolster
