// Designs made by hand for tests.
#pragma once

#include "Design.h"

namespace bolster {

inline constexpr ElementId testFabric{1};
inline constexpr ElementId firstSquare{2};
inline constexpr ElementId secondSquare{3};
inline constexpr ElementId squareSeam{4};
inline constexpr ElementId testCurve{5};
inline constexpr ElementId squareFixation{6};

/// Two squares of 100 mm, 100 mm apart; the right side of the first is sewn to the left side of the second, whose
/// right side is fixed.
inline Design twoSquares()
{
    const auto square = [](const char* name, const Vec2& position) {
        Patch patch;
        patch.name = name;
        patch.fabric = testFabric;
        patch.position = position;
        patch.outline = BSpline2(1, true, {{0, 0}, {100, 0}, {100, 100}, {0, 100}});
        return patch;
    };
    Edit edit;
    const auto add = [&](ElementId id, auto element) {
        edit.changes.push_back({id, nullptr, makeElement(element)});
    };
    add(testFabric, Fabric{"Leather"});
    add(firstSquare, square("First", {0, 0}));
    add(secondSquare, square("Second", {200, 0}));
    add(squareSeam, Seam{{firstSquare, 1, 2}, {secondSquare, 3, 4}});
    add(testCurve, FixationCurve{"Rail", BSpline3(1, false, {{300, 0, 0}, {300, 100, 0}})});
    FixationSeam fixation;
    fixation.stretch = {secondSquare, 1, 2};
    fixation.curve = testCurve;
    add(squareFixation, fixation);
    return Design().with(edit);
}

} // namespace bolster
