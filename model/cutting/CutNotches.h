// Where notches are: those that somebody placed with their partners across the seam, and those that follow from the
// seams.
#pragma once

#include "Design.h"

#include <map>
#include <stop_token>
#include <vector>

namespace bolster {

/// A place on an outline that gets a notch.
struct NotchPlace {
    double at = 0; ///< parameter of the outline
    NotchShape shape;
    bool twice = false;
    ElementId element{};
    ElementId seam{};
    double fraction = 0; ///< as in CutNotch
};

/// By patch, in increasing parameter; of two within 1 mm the one that somebody placed, or the first. `notches` says
/// which there are of themselves.
std::map<ElementId, std::vector<NotchPlace>> notchPlaces(const Design& design, const AutomaticNotches& notches,
                                                         const std::stop_token& stop = {});

} // namespace bolster
