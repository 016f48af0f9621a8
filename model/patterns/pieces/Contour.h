// Lines of a drawing, put together where their ends meet.
#pragma once

#include "Drawing.h"

namespace bolster {

/// Millimetres.
struct Contour {
    std::vector<DrawnPoint> points;
    bool closed = false;
    double gap = 0; ///< between the ends of an open one; of a closed one the largest that was closed
    double circle = 0;
    std::string layer;
    std::string called{}; ///< by who drew it
    std::vector<std::string> about;

    Box2 box() const;
    double signedArea() const;
    bool contains(const Vec2& point) const;
    double distance(const Vec2& point) const;
    std::vector<Vec2> places() const;
};

struct JoinOrder {
    double same = 0.02;    ///< mm: ends that are so near are one point
    double largestGap = 0; ///< mm: ends that are farther apart are joined by a line up to this
};

/// Lines that meet at their ends become one; what lies twice on itself is taken once, and counted in `doubled`.
/// Closed ones run counter-clockwise.
std::vector<Contour> joinedLines(std::vector<DrawnLine> lines, const JoinOrder& order, int& doubled);

} // namespace bolster
