// The parallel lines of a fancy seam. Private to PatchLines.
#pragma once

#include "PatchBorder.h"
#include "PatchLines.h"

namespace bolster {

/// From the one outer line to the other. Where the curve begins or ends at the outline, or beyond it, all of them
/// are led to the outline. When that is impossible, the reason.
struct FancyLines {
    std::vector<PatchLine> lines;
    std::optional<Message> reason;
};
FancyLines drawFancyLines(const FancySeam& seam, const PatchBorder& border, double edgeLength);

/// An end nearer than this to the outline lies on it, mm.
double outlineReach(double edgeLength);
/// "(x, y)" for messages.
std::string pointText(const Vec2& point);

} // namespace bolster
