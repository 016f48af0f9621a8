#include "CloudBuilder.h"
#include "CloudReaders.h"
#include "TextScanner.h"

#include <array>
#include <charconv>

namespace bolster {

namespace {

/// Of the words behind a point: red green blue, or a brightness and then those. Nothing where these are no bytes:
/// other programs write normals there.
std::optional<std::uint32_t> colorBehind(TextScanner& text)
{
    std::array<std::string_view, 4> words;
    std::size_t count = 0;
    for (; count < words.size(); ++count)
        if (words[count] = text.word(); words[count].empty())
            break;
    const bool brightness = count == 4 && !text.moreOnLine();
    if (count < 3)
        return std::nullopt;
    std::uint32_t color = 0;
    for (std::size_t i = brightness ? 1 : 0, end = i + 3; i < end; ++i) {
        std::uint8_t channel = 0;
        const char* const last = words[i].data() + words[i].size();
        const auto [at, error] = std::from_chars(words[i].data(), last, channel);
        if (error != std::errc() || at != last)
            return std::nullopt;
        color = color << 8 | channel;
    }
    return color;
}

} // namespace

PointCloud readXyz(const FileBytes& bytes)
{
    TextScanner text(bytes);
    CloudBuilder cloud(bytes);
    bool first = true;
    while (text.nextLine()) {
        const double x = text.number();
        const std::string_view second = text.word();
        if (std::exchange(first, false) && second.empty())
            continue; // some programs begin with the number of points
        const double y = text.number(second);
        const double z = text.number();
        cloud.addPoint({x, y, z}, text.place(), colorBehind(text));
    }
    return cloud.finish();
}

} // namespace bolster
