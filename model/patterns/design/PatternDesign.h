// Pieces that were found become patches of a design.
#pragma once

#include "Design.h"
#include "FoundPieces.h"

#include <set>

namespace bolster {

enum class PatternLines {
    Sew, ///< outlines are the sewing lines; the cut lines tell the allowances
    Cut  ///< outlines are the cut lines, without allowance
};

struct PatternChoice {
    PatternLines lines = PatternLines::Sew;
    std::optional<std::set<std::size_t>> only{}; ///< these pieces, by their places in the list
};

struct ImportedPattern {
    Edit edit; ///< empty when there is nothing to add
    std::vector<ElementId> patches;
    std::vector<std::size_t> taken; ///< which pieces these are, by their places in the list
    std::vector<Message> notes;     ///< what was left out, or made otherwise
};

/// Adds a patch for each piece, where it lies in the file or, if pieces lie on each other there, side by side; with
/// allowance, grain, notches, drill holes, inner lines, quantity. Fabrics of a name that there is are those. What
/// comes out has no errors: what would have some is fitted or left out, and told.
ImportedPattern patternEdit(const Design& design, const FoundPattern& pattern, const PatternChoice& choice = {});

} // namespace bolster
