// Changes of a pattern that may relieve its cloth.
#pragma once

#include "Reliefs.h"
#include "Tolerances.h"

namespace bolster {

/// A change by some amount, mm.
struct ReliefMove {
    Relief::Kind kind = Relief::Kind::LetOut;
    ElementId element{};
    ReliefPlace place;
    std::vector<Freedom> freedoms;  ///< each moves by the amount times its step
    const char* more = nullptr;     ///< Message for amounts above 0
    const char* less = nullptr;     ///< and below it
    std::vector<std::string> names; ///< %1, %2; the amount comes after them
};

/// Of all seams, edges that are held, and corners; of two that mirror each other the first one.
std::vector<ReliefMove> reliefMoves(const Design& design);
Design withMove(const Design& design, const ReliefMove& move, double amount);
/// Without what is predicted of it.
Relief reliefOf(const Design& design, const ReliefMove& move, double amount);

/// Each seam smooth that is sharp, and the other way round.
std::vector<Relief> continuityReliefs(const Design& design);

/// Darts of a few widths that run from the nearest edge to where patches are strained most.
std::vector<Relief> dartReliefs(const Design& design, const SurfaceTopology& topology, const CoverStrains& strains);

} // namespace bolster
