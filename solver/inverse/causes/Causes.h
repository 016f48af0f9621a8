// What may be wrong with a piece that was built: a few numbers each, and how large they may be.
#pragma once

#include "Tolerances.h"

namespace bolster {

struct Cause {
    enum class Kind {
        Foam,     ///< thicker or thinner, +-10 mm
        Strength, ///< of foam: harder or softer, +-50 %
        Seam,     ///< its allowance, +-3 mm on both sides
        Stretch,  ///< a piece is larger or smaller, +-5 %
        Fixation, ///< a curve lies elsewhere, +-10 mm along each axis
        Notch     ///< one side of a seam is sewn shifted, +-10 mm half way, not at its ends
    };

    Kind kind = Kind::Foam;
    ElementId element{};
    /// Their spread is a standard deviation: half of what is said above.
    std::vector<Tolerance> numbers;
    std::string name; ///< for people
};

/// "foam", "strength", "seam", "stretch", "fixation", "notch"
const char* wordOf(Cause::Kind kind);
/// "mm" or "%"
const char* unitOf(Cause::Kind kind);

/// What was built has no twins: one piece of two may be wrong.
Design withoutTwins(const Design& design);
/// Of a design without twins. A seam none of whose sides has a control point between its ends has no notch.
std::vector<Cause> possibleCauses(const Design& design);
/// What was built if a cause has these values, in its unit, as many as it has numbers.
Design withCause(const Design& design, const Cause& cause, const Eigen::VectorXd& values);
/// From what a tolerance counts to the unit of its cause.
double unitOf(const Tolerance& tolerance);

} // namespace bolster
