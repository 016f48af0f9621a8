// The production pattern: all pieces of a design, ready to be cut.
#pragma once

#include "CutPiece.h"
#include "Design.h"

#include <set>
#include <stop_token>

namespace bolster {

/// Words of labels, in the language of whoever gets them; %1 is a number.
struct CutWords {
    std::string single = "Cut %1";
    std::string pair = "Cut %1 and %1 mirrored";
};

struct CutOptions {
    double chord = 0.05;                       ///< how far a polygon may be from its curve, mm
    std::optional<double> allowance = {};      ///< mm, where the design says none
    std::optional<double> notchSpacing = {};   ///< mm, in place of the design's
    bool unfold = false;                       ///< the second one of a pair is a piece of its own
    bool faceUp = true;                        ///< patches that are worn wrong side out are mirrored
    std::optional<std::set<ElementId>> only{}; ///< these patches
    std::string style;                         ///< where the design has no name for it: that of the file
    CutWords words;
};

struct CutPattern {
    std::string style;
    std::string version;
    std::vector<CutPiece> pieces;   ///< by patch
    std::vector<ElementId> leftOut; ///< patches whose outlines enclose nothing or cross themselves
};

/// Without the rest of its pieces when it is stopped.
CutPattern cutPattern(const Design& design, const CutOptions& options, const std::stop_token& stop = {});

/// The allowance that holds for a patch where none of its edges has another one.
CutAllowance allowanceOf(const Design& design, const Patch& patch, std::optional<double> otherwise = {});

} // namespace bolster
