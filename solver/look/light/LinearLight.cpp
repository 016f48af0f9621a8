#include "LinearLight.h"

#include "Shading.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bolster {

float toLinear(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float toEncoded(float linear)
{
    return shading::encoded(std::clamp(linear, 0.f, 1.f));
}

Light lightOf(const std::string& color)
{
    const auto hex = [](char c) {
        return c >= '0' && c <= '9' ? c - '0' : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10 : -1;
    };
    if (color.size() != 7 || color[0] != '#' ||
        std::any_of(color.begin() + 1, color.end(), [&](char c) { return hex(c) < 0; }))
        return Light::Constant(0.2f);
    Light light;
    for (std::size_t i = 0; i < 3; ++i)
        light[static_cast<Eigen::Index>(i)] =
            toLinear(static_cast<float>(16 * hex(color[1 + 2 * i]) + hex(color[2 + 2 * i])) / 255);
    return light;
}

std::string textOf(const Light& light)
{
    const auto byte = [](float value) { return static_cast<unsigned>(std::lround(255 * toEncoded(value))); };
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(light[0]), byte(light[1]), byte(light[2]));
    return text;
}

float luminance(const Light& light)
{
    return 0.2126f * light[0] + 0.7152f * light[1] + 0.0722f * light[2];
}

} // namespace bolster
