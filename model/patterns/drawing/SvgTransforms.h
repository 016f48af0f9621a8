// Where elements of SVG lie: transforms and viewports. Private to the library.
#pragma once

#include "Geometry.h"

#include <Eigen/Geometry>

#include <optional>
#include <string_view>

namespace bolster {

/// Of "translate(3) rotate(90 5 5) matrix(...)", or as CSS has it: "rotate(0.25turn) translateX(3mm)". Nothing
/// where it cannot be read to its end.
std::optional<Eigen::Affine2d> svgTransform(std::string_view text);
/// Around the point of `origin` ("10 20"), if it says one.
std::optional<Eigen::Affine2d> svgTransform(std::string_view text, std::string_view origin);

/// Nothing where it is none, or empty.
std::optional<Box2> svgViewBox(std::string_view text);
/// From a view box to a viewport of that size at 0, 0, as preserveAspectRatio has it.
Eigen::Affine2d svgViewport(const Box2& box, const Vec2& size, std::string_view aspect);

} // namespace bolster
