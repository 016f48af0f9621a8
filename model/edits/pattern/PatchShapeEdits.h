// Scaling and mirroring of patches.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Scales patches with the curves drawn in them about a layout point (mm), by these factors along the layout's
/// axes. Factors within 0.001 to 1000; else, and when nothing would change, empty. Grain, widths of fancy seams and
/// targets of handle curves stay.
Edit scalePatches(const Design& design, std::span<const ElementId> patches, const Vec2& centre,
                  const Vec2& factors);
/// Gives each patch another width (axis 0) or height (1), mm, as it lies in the layout; the lower left corner of
/// its box stays. Limits as for scalePatches.
Edit resizePatches(const Design& design, std::span<const ElementId> patches, int axis, double size);

/// Across which line a patch is mirrored: Vertical makes a left side of a right side.
enum class MirrorAxis { Vertical, Horizontal };

/// Mirrors patches with the curves drawn in them and their grain about a vertical or horizontal line of the layout
/// (its x or y, mm). The outline keeps its parameters and so runs the other way round; the right side stays up.
/// Seams stay on the same stretches: among mirrored patches nothing changes, those to other patches are turned
/// round, so that right side still meets right side. Fixations stay as they are.
Edit mirrorPatches(const Design& design, std::span<const ElementId> patches, MirrorAxis axis, double at);

} // namespace bolster::edits
