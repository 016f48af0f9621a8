// A box around some pieces of a frame, in the 3D view.
#pragma once

#include "DesignFiles.h"
#include "ViewScene.h"

#include <vector>

namespace bolster {

class Design;

/// Which pieces of which frame (FramePieces); without any there is no box.
struct FramePieceBox {
    ElementId frame{};
    std::vector<int> pieces;

    /// Adds its edges to the lines; hidden pieces count, too.
    void addTo(ViewScene& scene, const Design& design, const DesignFiles& files) const;

    friend bool operator==(const FramePieceBox&, const FramePieceBox&) = default;
};

} // namespace bolster
