// From where a picture looks, in words or angles.
#pragma once

#include "PreviewRenderer.h"

#include <string_view>

namespace bolster {

/// A direction against the cover's front, radians: azimuth to its right, elevation upwards.
struct PictureDirection {
    double azimuth = 0;
    double elevation = 0;
};

/// "three-quarter", "front", "back", "left", "right", "top"; or two numbers in degrees, "30,20". The sides are
/// those of somebody who looks at the front.
std::optional<PictureDirection> pictureDirection(std::string_view words);
/// The words above, for a message.
inline constexpr const char* pictureDirections = "three-quarter, front, back, left, right, top";

/// The whole cover from there. `aspect` is width over height.
RayCamera pictureView(const Scene& scene, const PictureDirection& from, double aspect);

} // namespace bolster
