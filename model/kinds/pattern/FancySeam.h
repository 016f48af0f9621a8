// A decorative seam that presses a groove into a patch, or raises a welt (paper, section 3.5).
#pragma once

#include "PatchCurve.h"
#include "SeamTrim.h"

#include <string>

namespace bolster {

/// The cross section from one outer line to the other, u from -1 to 1 (formulas: fancyProfile).
enum class Profile { Round, Sharp, Welt };

struct FancySeam : PatchCurve {
    double width = 12; ///< between the outer lines, in the pattern, mm, > 0
    double depth = 4;  ///< of the curve below the cover, mm; negative: above it
    Profile profile = Profile::Round;
    SeamTrim trim = {};
    std::string note = {}; ///< for people

    friend bool operator==(const FancySeam&, const FancySeam&) = default;
};

/// Share of the depth at u: 1 at 0 and 0 from -1 and 1 outwards. Round: a bell, cos^2(pi u / 2). Sharp: a crease in
/// the middle, smooth shoulders, (1 - |u|)^2. Welt: round in the middle, creases beside it, 1 - u^2.
double fancyProfile(Profile profile, double u);

} // namespace bolster
