// A NURBS curve of a drawing, of any degree. Private to the library.
#pragma once

#include "DrawingPen.h"

namespace bolster {

struct RationalSpline {
    int degree = 3;
    std::vector<Vec2> points;
    std::vector<double> knots;   ///< points + degree + 1
    std::vector<double> weights; ///< none: all 1

    /// Whether it is a curve: enough points and knots that do not decrease.
    bool isSound() const;
    void draw(DrawingPen& pen) const;

private:
    Vec2 at(double t, std::size_t span) const;
};

} // namespace bolster
