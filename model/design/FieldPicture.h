// What the view shows of the forces that cushioning puts on a cover.
#pragma once

#include "Geometry.h"

#include <array>
#include <memory>
#include <vector>

namespace bolster {

/// Line segments in space, mm.
struct FieldPicture {
    using Segment = std::array<Eigen::Vector3f, 2>;

    std::vector<Segment> contours; ///< sections of the cushioning's surface
    std::vector<Segment>
        arrows; ///< in a middle plane: from where a force f acts to the target that it sets, f / 2 away
};

using FieldPicturePtr = std::shared_ptr<const FieldPicture>;

} // namespace bolster
