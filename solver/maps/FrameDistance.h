// The frames of a design, to measure distances from.
#pragma once

#include "Design.h"
#include "DesignFiles.h"

#include <memory>
#include <utility>
#include <vector>

namespace bolster {

class TriangleTree;

/// What the frames hide does not count. Kept while they stay what and where they are.
class FrameDistance {
public:
    /// Null without frames whose meshes are known.
    const TriangleTree* tree(const Design& design, const DesignFiles& files);

private:
    std::vector<std::pair<std::shared_ptr<const TriangleMesh>, Placement>> m_of;
    std::shared_ptr<const TriangleTree> m_tree;
};

} // namespace bolster
