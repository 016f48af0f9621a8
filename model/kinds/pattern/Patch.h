// A piece of the sewing pattern.
#pragma once

#include "BSpline.h"
#include "ElementId.h"
#include "PieceCutting.h"
#include "Twin.h"

#include <optional>
#include <string>

namespace bolster {

/// The right side is +z of the pattern plane whichever way the outline runs, unless `wrongSideOut`.
/// Position and rotation say where the patch lies in the layout; they enter neither solver nor texture.
struct Patch {
    std::string name;
    ElementId fabric{};
    Vec2 position = Vec2::Zero(); ///< of the outline's origin in the layout, mm
    double rotation = 0;          ///< in the layout, degrees, counter-clockwise
    double grain = 90;            ///< direction of the warp in outline coordinates, degrees, counter-clockwise
    double pressure = 0;       ///< 1 is a membrane force per D in units of the stretch stiffness (docs/solver.md)
    bool wrongSideOut = false; ///< worn with -z of the pattern plane outside
    BSpline2 outline;          ///< closed, mm
    std::optional<CutAllowance> allowance = {}; ///< nothing: the design's
    PieceCutting cutting = {};
    std::optional<Twin> twin = {}; ///< mirrored at x = 0 of the outlines; place and rotation are free
    std::string note = {};         ///< for people

    friend bool operator==(const Patch&, const Patch&) = default;
};

/// Outline coordinates to layout coordinates and back.
Vec2 toLayout(const Patch& patch, const Vec2& outlinePoint);
Vec2 fromLayout(const Patch& patch, const Vec2& layoutPoint);

} // namespace bolster
