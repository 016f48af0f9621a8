// The point of a triangle that is nearest to another one.
#pragma once

#include <Eigen/Core>

namespace bolster {

/// Of a triangle without area some point of it. Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
template <class Point>
Point nearestOnTriangle(const Point& point, const Point& a, const Point& b, const Point& c)
{
    const Point ab = b - a, ac = c - a;
    const auto d1 = ab.dot(point - a), d2 = ac.dot(point - a);
    if (d1 <= 0 && d2 <= 0)
        return a;
    const auto d3 = ab.dot(point - b), d4 = ac.dot(point - b);
    if (d3 >= 0 && d4 <= d3)
        return b;
    const auto vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return a + d1 / (d1 - d3) * ab;
    const auto d5 = ab.dot(point - c), d6 = ac.dot(point - c);
    if (d6 >= 0 && d5 <= d6)
        return c;
    const auto vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return a + d2 / (d2 - d6) * ac;
    const auto va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    const auto all = va + vb + vc;
    return all > 0 ? Point(a + (vb * ab + vc * ac) / all) : a;
}

} // namespace bolster
