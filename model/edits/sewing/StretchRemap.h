// What becomes of seams, fixations and trims when outlines are cut or joined. Private to the library.
#pragma once

#include "EditBuilder.h"

#include <map>

namespace bolster::edits {

/// A part of an old outline and where it lies now. What no arc covers is gone.
struct OutlineArc {
    double from = 0; ///< of the old outline
    double to = 0;   ///< larger than `from`, by the period at most
    ElementId patch{};
    double start = 0;       ///< the parameter there that `from` has
    bool backwards = false; ///< the new outline runs the other way
};

/// By the old patch; other patches stay as they are.
using OutlineArcs = std::map<ElementId, std::vector<OutlineArc>>;

/// Rewrites the seams, fixation seams and marks on outlines of `before` for the outlines of `builder.now()`, all
/// but those in `except`. One that runs over the end of an arc is divided into several; one of which nothing is
/// left is removed and added to `dropped`.
void remapStretches(const Design& before, const OutlineArcs& arcs, const std::set<ElementId>& except,
                    EditBuilder& builder, std::vector<ElementId>& dropped);

/// The directions from one fraction of the length to another, in the other direction if `from` is larger.
Orientation partOf(const Orientation& orientation, double from, double to);

} // namespace bolster::edits
