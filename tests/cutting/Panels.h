// Two square panels that are sewn together.
#pragma once

#include "Design.h"

namespace bolster::test {

inline constexpr ElementId leather{1}, left{2}, right{3}, between{4};

inline BSpline2 rectangle(double width, double height)
{
    return BSpline2(1, true, {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

/// The right edge of one (parameters 1 to 2) to the left one of the other (3 to 4).
inline Design twoPanels(double widthA = 200, double widthB = 200)
{
    Fabric fabric;
    fabric.name = "Leather";
    Patch a, b;
    a.name = "Left";
    a.fabric = leather;
    a.outline = rectangle(widthA, 100);
    b = a;
    b.name = "Right";
    b.position = {300, 0};
    b.outline = rectangle(widthB, 100);
    Seam seam;
    seam.a = {left, 1, 2};
    seam.b = {right, 3, 4};
    seam.reversed = true;
    Edit edit;
    edit.changes = {{leather, nullptr, makeElement(fabric)},
                    {left, nullptr, makeElement(a)},
                    {right, nullptr, makeElement(b)},
                    {between, nullptr, makeElement(seam)}};
    return Design().with(edit);
}

template <class T>
Design with(const Design& design, ElementId id, T value)
{
    return design.with({{}, {{id, nullptr, makeElement(std::move(value))}}});
}

} // namespace bolster::test
