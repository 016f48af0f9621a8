// What makes a patch or curve the mirror twin of another.
#pragma once

#include "ElementId.h"

#include <vector>

namespace bolster {

/// Only one of two twins, the follower, has this; in effect they are equals: an edit of either changes both. Point
/// i of one belongs to point i of the other, and equal parameters belong together.
struct Twin {
    ElementId of{};            ///< the other one, of the same kind
    std::vector<int> released; ///< points of both that go their own ways: increasing, see firstTwinSpacePoint

    friend bool operator==(const Twin&, const Twin&) = default;
};

} // namespace bolster
