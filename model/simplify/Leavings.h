// What a simplified mesh has that the mesh had not: triangles that hang on edges of the others.
#pragma once

#include <cstdint>
#include <vector>

namespace bolster {

/// Three numbers of points for each triangle.
using Corners = std::vector<std::uint32_t>;

/// Without pairs of triangles that have the same corners, one seen from either side (fins), and without pockets: a
/// few triangles on edges that two others have in common. Where there are many, that is how the mesh is: nothing
/// is taken away.
Corners withoutLeavings(Corners corners);

} // namespace bolster
