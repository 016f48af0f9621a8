// A seam between two stretches: ((i, r, s), (j, r', s')) of the paper, section 3.1.
#pragma once

#include "SeamTrim.h"
#include "Stretch.h"

#include <string>

namespace bolster {

enum class Continuity { C0, C1, G1 }; ///< paper, section 3.4

struct Seam {
    Stretch a;
    Stretch b;
    bool reversed = true; ///< b is walked backwards
    Match match = Match::Length;
    Continuity continuity = Continuity::C0;
    SeamTrim trim = {};
    double ease = 0;       ///< how much longer than the first side the second one is wanted, mm
    bool zip = false;      ///< a zip joins its sides
    double step = 0;       ///< its place in the order of sewing; 0: as is proposed
    std::string note = {}; ///< for people

    friend bool operator==(const Seam&, const Seam&) = default;
};

} // namespace bolster
