// Threads and pipes as triangles.
#pragma once

#include "RefinedPlaces.h"
#include "TrimMesh.h"

#include <span>

namespace bolster {

/// Points of a stitch on a cover from where the thread comes up to where it goes down again.
constexpr int stitchPoints = 5;

/// Adds a stitch that lies on the cover and whose ends dive into it. `width`: of the thread, mm.
void addStitch(std::span<const CoverPoint3, stitchPoints> on, float width, TrimMesh& to);

/// Adds a pipe along these points. Open ones get round ends. Points nearer to each other than a quarter of the
/// radius are passed over. `radius`: mm.
void addPipe(const std::vector<CoverPoint3>& along, bool closed, float radius, TrimMesh& to);

} // namespace bolster
