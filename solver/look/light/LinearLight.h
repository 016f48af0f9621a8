// Colours as light and as they are written.
#pragma once

#include <Eigen/Core>

#include <string>

namespace bolster {

using Light = Eigen::Array3f; ///< red, green, blue; linear, 0 to 1

/// sRGB's curve (IEC 61966-2-1), both ways; 0 to 1.
float toLinear(float encoded);
float toEncoded(float linear);

/// "#rrggbb" as light; middle grey for anything else.
Light lightOf(const std::string& color);
std::string textOf(const Light& light);

float luminance(const Light& light);

} // namespace bolster
