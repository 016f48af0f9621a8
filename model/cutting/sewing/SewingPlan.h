// What the sewing room is told: the pieces, the seams in an order that works, what is needed.
#pragma once

#include "CutPattern.h"
#include "SeamTrim.h"

#include <map>

namespace bolster {

struct PlannedSeam {
    ElementId seam{};
    ElementId patchA{};
    ElementId patchB{};
    double lengthA = 0; ///< mm
    double lengthB = 0;
    double ease = 0;       ///< how much longer B is than A, % of the shorter one
    double allowanceA = 0; ///< mm, in the middle of the side
    double allowanceB = 0;
    int notches = 0; ///< on its first side
    SeamTrim trim;
    bool zip = false;
    bool closes = false; ///< everything that it joins hangs together before it
};

struct FabricNeed {
    std::string name;
    double area = 0; ///< of the pieces as they are cut, mm2: what lies between them comes on top
};

struct SewingPlan {
    CutPattern pattern;
    std::vector<PlannedSeam> seams; ///< in the order in which they are sewn
    std::vector<FabricNeed> fabrics;
    std::map<std::string, double> thread; ///< by colour, mm; "": of seams without top stitching
    double piping = 0;                    ///< mm
    double zips = 0;                      ///< mm
};

/// Sewing thread for each length of a row of lockstitch, both threads together.
inline constexpr double threadPerSeam = 3;

/// The seams as sewingOrder() has them. Incomplete when it is stopped.
SewingPlan sewingPlan(const Design& design, const CutOptions& options, const std::stop_token& stop = {});

} // namespace bolster
