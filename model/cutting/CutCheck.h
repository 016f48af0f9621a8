// What is wrong with a pattern before it is cut.
#pragma once

#include "CutPattern.h"
#include "Problem.h"

namespace bolster {

/// What comes of it if nobody looks: the gravest first.
enum class CutHarm { CannotBeCut, Weakened, DoesNotFit, Inconvenient };

struct CutFinding {
    Problem problem;           ///< a warning; of the element that is meant
    ElementId patch{};         ///< on which it is to be seen; none: of no single one
    Vec2 place = Vec2::Zero(); ///< in the patch's outline coordinates, mm
    CutHarm harm = CutHarm::Inconvenient;
    double amount = 0; ///< of two alike the larger one is worse
};

/// Sides of seams that are not as long as wanted, notches that nobody meets or that reach the sewing line, labels
/// without room, pieces that are wider than their fabric, inner corners that cannot be spread, cut lines that meet,
/// lines and holes that reach out of their piece, darts that all but divide it. What is worst comes first.
/// Incomplete when it is stopped.
std::vector<CutFinding> checkCutting(const Design& design, const CutPattern& pattern,
                                     const std::stop_token& stop = {});

} // namespace bolster
