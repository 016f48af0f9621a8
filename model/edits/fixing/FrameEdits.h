// What of a frame is left out.
#pragma once

#include "Design.h"
#include "FramePieces.h"

namespace bolster::edits {

/// Leaves pieces of the frame's mesh (FramePieces) out for everybody, or takes them back in.
Edit showFramePieces(const Design& design, ElementId frame, const FrameMeshPtr& mesh,
                     const std::vector<int>& pieces, bool shown);

} // namespace bolster::edits
