// The edges of all outlines, and what of them is free. Private to the library.
#pragma once

#include "Design.h"

#include <map>
#include <set>

namespace bolster {

struct OutlineEdge {
    Stretch stretch;
    double length = 0;          ///< mm
    double corner = 180;        ///< inner angle of the piece where the edge begins, counter-clockwise, degrees
    Vec2 way = Vec2::Zero();    ///< from its start to its end in the layout, of length 1
    Vec2 middle = Vec2::Zero(); ///< in the layout, mm
    double alongGrain = 0;      ///< the same along the grain: 1 up, -1 down
    int next = 0;               ///< the edge that follows counter-clockwise, seen from the right side
    int before = 0;
    bool backwards = false;        ///< the stretch runs clockwise, seen from there
    bool taken = false;            ///< sewn
    bool fixed = false;            ///< to the frame
    int partner = -1;              ///< the edge that it is sewn to, if it is sewn as a whole
    std::set<std::string> words;   ///< of the patch's name, in lower case
    std::vector<double> notches{}; ///< shares of its length, counter-clockwise
};

/// By the names alone: one piece is called left and the other one right.
bool onOppositeSides(const OutlineEdge& a, const OutlineEdge& b);

/// The outline's parameter at this share of an edge's length, counter-clockwise.
double placeOn(const Design& design, const OutlineEdge& edge, double share);

/// Parameters of outlines, by patch.
using EdgeBreaks = std::map<ElementId, std::vector<double>>;

/// From corner to corner, and to the ends of seams and to more places in between.
std::vector<OutlineEdge> outlineEdges(const Design& design, const EdgeBreaks& more = {});

} // namespace bolster
