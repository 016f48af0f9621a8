// Covers made by hand for the tests of pictures.
#pragma once

#include "PreviewRenderer.h"

namespace bolster::test {

/// A flat patch of width x height mm in the plane z = 0, its corner at the origin, right side up, with a grid of
/// `cells` x `cells` squares.
SurfaceMeshPtr flatPatch(double width, double height, int cells = 8);

/// The same, changed by `change(mesh)`.
template <class Change>
SurfaceMeshPtr changed(const SurfaceMeshPtr& mesh, const Change& change)
{
    auto copy = std::make_shared<SurfaceMesh>(*mesh);
    change(*copy);
    return copy;
}

/// Two patches that meet at a right angle along a seam: a seat and a back.
SurfaceMeshPtr corner(double size);

/// Straight down; one pixel is `pixel` mm wide at the height of the target.
RayCamera fromAbove(const Vec3& target, double pixel, int height);

/// The pixel's brightness, 0 to 255.
int brightness(const PreviewImage& image, int x, int y);

} // namespace bolster::test
