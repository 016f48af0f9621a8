#include "PreviewMeshes.h"

#include <cmath>
#include <numbers>

namespace bolster::test {

namespace {

struct Builder {
    std::shared_ptr<SurfaceTopology> topology = std::make_shared<SurfaceTopology>();
    std::shared_ptr<SurfaceMesh> mesh = std::make_shared<SurfaceMesh>();

    /// A grid spanned by two vectors; returns its first vertex.
    std::uint32_t addGrid(ElementId patch, const Vec3& origin, const Vec3& u, const Vec3& v, int cells)
    {
        const std::uint32_t first = topology->vertexCount(), row = static_cast<std::uint32_t>(cells) + 1;
        const auto firstTriangle = static_cast<std::uint32_t>(topology->triangles.size());
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                const double s = static_cast<double>(i) / cells, t = static_cast<double>(j) / cells;
                mesh->positions.push_back(origin + s * u + t * v);
                mesh->normals.push_back(u.cross(v).normalized().cast<float>());
                topology->pattern.push_back({s * u.norm(), t * v.norm()});
                topology->unknown.push_back(topology->unknownCount++);
            }
        for (std::uint32_t j = 0; j + 1 < row; ++j)
            for (std::uint32_t i = 0; i + 1 < row; ++i) {
                const std::uint32_t k = first + j * row + i;
                topology->triangles.push_back({k, k + 1, k + row + 1});
                topology->triangles.push_back({k, k + row + 1, k + row});
            }
        topology->patches.push_back({patch, ElementId{1}, first, row * row, firstTriangle,
                                     static_cast<std::uint32_t>(topology->triangles.size()) - firstTriangle, 0});
        return first;
    }

    SurfaceMeshPtr finish()
    {
        mesh->topology = topology;
        return mesh;
    }
};

} // namespace

SurfaceMeshPtr flatPatch(double width, double height, int cells)
{
    Builder builder;
    builder.addGrid(ElementId{2}, Vec3::Zero(), {width, 0, 0}, {0, height, 0}, cells);
    return builder.finish();
}

SurfaceMeshPtr corner(double size)
{
    constexpr std::uint32_t cells = 10;
    Builder builder;
    const std::uint32_t seat = builder.addGrid(ElementId{2}, Vec3::Zero(), {size, 0, 0}, {0, size, 0}, cells);
    const std::uint32_t back = builder.addGrid(ElementId{3}, {0, size, 0}, {size, 0, 0}, {0, 0, size}, cells);
    SurfaceTopology::Chain seam{ElementId{4}, {}, {}};
    for (std::uint32_t i = 0; i <= cells; ++i) {
        seam.a.push_back(seat + cells * (cells + 1) + i);
        seam.b.push_back(back + i);
    }
    builder.topology->seams.push_back(seam);
    return builder.finish();
}

RayCamera fromAbove(const Vec3& target, double pixel, int height)
{
    RayCamera view;
    view.target = target;
    view.azimuth = 0;
    view.elevation = std::numbers::pi / 2;
    view.perspective = false;
    view.distance = pixel * height / (2 * std::tan(view.fieldOfView / 2));
    return view;
}

int brightness(const PreviewImage& image, int x, int y)
{
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return (image.rgba[at] + image.rgba[at + 1] + image.rgba[at + 2]) / 3;
}

} // namespace bolster::test
