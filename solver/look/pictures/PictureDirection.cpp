#include "PictureDirection.h"

#include "MeshShape.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace bolster {

namespace {

constexpr double degree = std::numbers::pi / 180;

constexpr std::array<std::pair<std::string_view, PictureDirection>, 6> named = {
    {{"three-quarter", {-40 * degree, 20 * degree}},
     {"front", {0, 8 * degree}},
     {"back", {180 * degree, 8 * degree}},
     {"left", {-90 * degree, 8 * degree}},
     {"right", {90 * degree, 8 * degree}},
     {"top", {0, 90 * degree}}}};

std::optional<double> number(std::string_view text)
{
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc() && stop == text.data() + text.size() && std::abs(value) <= 360;
    return good ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<PictureDirection> pictureDirection(std::string_view words)
{
    const auto found = std::ranges::find(named, words, &std::pair<std::string_view, PictureDirection>::first);
    if (found != named.end())
        return found->second;
    const std::size_t comma = words.find(',');
    if (comma == std::string_view::npos)
        return std::nullopt;
    const auto azimuth = number(words.substr(0, comma)), elevation = number(words.substr(comma + 1));
    if (!azimuth || !elevation || std::abs(*elevation) > 90)
        return std::nullopt;
    return PictureDirection{*azimuth * degree, *elevation * degree};
}

RayCamera pictureView(const Scene& scene, const PictureDirection& from, double aspect)
{
    const double front = scene.surface ? frontAzimuth(scene.surface->positions) : 0;
    return RayCamera::around(scene.boundingBox(), aspect, front + from.azimuth, from.elevation);
}

} // namespace bolster
