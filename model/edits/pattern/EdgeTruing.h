// An edge of an outline that becomes longer or shorter while everything beside it stays as much as possible.
// Private to the library.
#pragma once

#include "BSpline.h"
#include "Stretch.h"

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace bolster::edits {

/// What is known of the outline around the edge.
struct EdgeSurroundings {
    std::set<int> pinned;                    ///< control points that stay where they are
    std::vector<std::pair<int, int>> mouths; ///< of darts: the corners at their ends, in the order of the outline
    std::vector<Stretch> used;               ///< of this outline: sewn or held, so their lengths matter
};

/// The outline with another length (mm) of the edge that these control points make, from a corner to another one.
/// A curve that is deep enough bulges, and both its ends stay. Else it keeps its shape, and one end moves: the one
/// that changes less. The edge beyond keeps its shape, so a straight one stays straight; a dart that begins at the
/// end goes along as it is. Nothing where that leads to no outline.
std::optional<BSpline2> truedEdge(const BSpline2& outline, const std::vector<int>& points, double length,
                                  const EdgeSurroundings& around);
/// The same; it always keeps its shape, and its middle.
std::optional<BSpline2> edgeAboutMiddle(const BSpline2& outline, const std::vector<int>& points, double length,
                                        const EdgeSurroundings& around);

} // namespace bolster::edits
