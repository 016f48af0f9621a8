#include "RenderOrder.h"

#include <array>
#include <charconv>

namespace bolster::cli {

namespace {

constexpr std::array rules = {
    OptionRule{"--image", true},     OptionRule{"--size", true},    OptionRule{"--view", true},
    OptionRule{"--samples", true},   OptionRule{"--fabric", true},  OptionRule{"--map", true},
    OptionRule{"--turntable", true}, OptionRule{"--threads", true}, OptionRule{"--transparent", false},
    OptionRule{"--sheet", false},
};

/// "1280x960"
std::array<int, 2> parsedSize(const std::string& text)
{
    std::array<int, 2> size{};
    const char* const end = text.data() + text.size();
    const auto [middle, error] = std::from_chars(text.data(), end, size[0]);
    const bool cross = error == std::errc() && middle < end && *middle == 'x';
    if (cross) {
        const auto [stop, wrong] = std::from_chars(middle + 1, end, size[1]);
        if (wrong == std::errc() && stop == end && size[0] > 0 && size[1] > 0)
            return size;
    }
    throw UsageError("--size needs width and height in pixels, like 1280x960, not \"" + text + "\"");
}

void checkSize(const PreviewOptions& options)
{
    constexpr int longest = 16384;
    const std::int64_t pixels = static_cast<std::int64_t>(options.width) * options.height;
    const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
    if (options.width > longest || options.height > longest)
        throw UsageError("--size " + size + " is too large: at most " + std::to_string(longest) + " pixels a side");
    if (pixels > mostPixels)
        throw UsageError("--size " + size + " is too large: " + std::to_string(pixels / 1'000'000) +
                         " million pixels, and at most " + std::to_string(mostPixels / 1'000'000) + " are drawn");
}

void takeMap(const Arguments& arguments, RenderOrder& order)
{
    const std::string map = arguments.path("--map").toStdString();
    order.checker = map == "checker";
    order.map = coverMapKind(map);
    if (!map.empty() && !order.checker && !order.map)
        throw UsageError("unknown map \"" + map +
                         "\"; there are strain, along, across, shear, curvature, thickness and checker");
    if (order.map && !order.colourway.empty())
        throw UsageError("--map " + map + " and --fabric exclude each other: a map covers the fabric");
}

} // namespace

RenderOrder RenderOrder::from(std::span<const std::string> words)
{
    const Arguments arguments(words, rules);
    RenderOrder order;
    order.design = arguments.onlyFile("DESIGN");
    order.image = arguments.path("--image");
    if (order.image.isEmpty())
        throw UsageError("--image is missing: where the picture is to be written");
    const auto format = pictureFormat(order.image.toStdString());
    if (!format)
        throw UsageError("--image must end in .png, .tif or .exr, and \"" + order.image.toStdString() +
                         "\" does not");
    order.format = *format;
    order.options.light = needsLight(order.format);
    order.options.samples = arguments.integer("--samples", 16, 1, 256);
    order.options.threads = arguments.integer("--threads", 0, 0, 1024);
    order.options.transparent = arguments.has("--transparent");
    if (arguments.has("--size")) {
        const auto [width, height] = parsedSize(arguments.path("--size").toStdString());
        order.options.width = width;
        order.options.height = height;
    }
    checkSize(order.options);
    order.viewName = arguments.has("--view") ? arguments.path("--view").toStdString() : "three-quarter";
    const auto direction = pictureDirection(order.viewName);
    if (!direction)
        throw UsageError("unknown view \"" + order.viewName + "\"; there are " + pictureDirections +
                         ", or azimuth and elevation in degrees, like 30,20");
    order.direction = *direction;
    order.colourway = arguments.path("--fabric").toStdString();
    takeMap(arguments, order);
    order.sheet = arguments.has("--sheet");
    order.turntable = arguments.integer("--turntable", 0, 1, 999);
    if (order.sheet && (order.turntable > 0 || order.map || order.checker || !order.colourway.empty()))
        throw UsageError(
            "--sheet shows all colourways in one picture: it goes neither with --fabric, nor with --map, "
            "nor with --turntable");
    return order;
}

} // namespace bolster::cli
