#include "PictureTones.h"

#include "LinearLight.h"
#include "Srgb.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

using shading::screenShoulder;

float bent(float light)
{
    return std::clamp(shading::toned(light, screenShoulder), 0.f, 1.f);
}

} // namespace

int orderInBlock(int x, int y)
{
    int order = 0;
    for (int bit = 0; bit < 3; ++bit)
        order = order << 2 | ((x ^ y) >> bit & 1) << 1 | (y >> bit & 1);
    return order;
}

std::array<float, 4> displayedShares(const PixelLight& light)
{
    const float opacity = std::clamp(light.opacity, 0.f, 1.f);
    std::array<float, 4> shown{0, 0, 0, opacity};
    if (opacity <= 0)
        return shown;
    for (int channel = 0; channel < 3; ++channel)
        shown[static_cast<std::size_t>(channel)] = srgbFromLinear(bent(light.color[channel] / opacity));
    // Programs mix what is displayed, not light: there half of the light is 0.74 of white.
    const float black = light.color.isZero() ? 1.f : 0.f;
    shown[3] = opacity + black * (1 - srgbFromLinear(1 - opacity) - opacity);
    return shown;
}

std::array<std::uint8_t, 4> displayed(const PixelLight& light, int x, int y)
{
    const std::array<float, 4> shown = displayedShares(light);
    const float offset = (static_cast<float>(orderInBlock(x, y)) + 0.5f) / 64.f;
    std::array<std::uint8_t, 4> bytes{};
    for (std::size_t channel = 0; channel < 4; ++channel)
        bytes[channel] =
            static_cast<std::uint8_t>(std::clamp(std::floor(255.f * shown[channel] + offset), 0.f, 255.f));
    if (light.opacity >= 1)
        bytes[3] = 255;
    return bytes;
}

Vec3f lightDisplayedAs(const std::string& color)
{
    return lightOf(color).unaryExpr([](float shown) {
        const float over = (std::min(shown, 0.99f) - screenShoulder) / (1 - screenShoulder);
        return over < 0 ? shown : screenShoulder - (1 - screenShoulder) * std::log(1 - over);
    });
}

} // namespace bolster
