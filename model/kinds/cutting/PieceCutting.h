// What a cutter has to know of one piece of the pattern.
#pragma once

#include "CutAllowance.h"
#include "Geometry.h"

#include <optional>
#include <string>

namespace bolster {

/// Which ways round a piece may lie on the fabric.
enum class Nap {
    TwoWays, ///< along the grain, either end up
    OneWay,  ///< one end up: velvet, patterns with a top
    Any      ///< any direction: leather, felt
};

/// Where the label stands, if not where it finds room.
struct PieceLabelPlace {
    Vec2 position = Vec2::Zero(); ///< of its middle, outline coordinates, mm
    double rotation = 0;          ///< of its lines, degrees, counter-clockwise

    friend bool operator==(const PieceLabelPlace&, const PieceLabelPlace&) = default;
};

struct PieceCutting {
    double quantity = 1; ///< whole; pairs count as one
    bool pair = false;   ///< each is cut once as it is and once mirrored
    Nap nap = Nap::TwoWays;
    double tolerance = 2; ///< how far the grain may be off, degrees
    std::string note;     ///< one more line of the label
    std::optional<PieceLabelPlace> label = {};

    friend bool operator==(const PieceCutting&, const PieceCutting&) = default;
};

} // namespace bolster
