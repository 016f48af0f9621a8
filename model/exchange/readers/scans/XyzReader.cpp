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

void addPointOfLine(TextScanner& text, std::string_view first, std::string_view second, CloudBuilder& cloud)
{
    const double x = text.number(first);
    const double y = text.number(second);
    const double z = text.number();
    cloud.addPoint({x, y, z}, text.place(), colorBehind(text));
}

} // namespace

PointCloud readXyz(const FileBytes& bytes)
{
    TextScanner text(bytes);
    CloudBuilder cloud(bytes);
    bool first = true;
    while (text.nextLine()) {
        const std::string_view x = text.word(), y = text.word();
        if (!(std::exchange(first, false) && y.empty())) // some programs begin with the number of points
            addPointOfLine(text, x, y, cloud);
        else
            text.number(x);
    }
    return cloud.finish();
}

PointCloud readPts(const FileBytes& bytes)
{
    TextScanner text(bytes);
    CloudBuilder cloud(bytes);
    std::uint64_t promised = 0, read = 0;
    while (text.nextLine()) {
        const std::string_view x = text.word(), y = text.word();
        if (y.empty()) { // another scan begins
            promised += std::min(text.count(x), largestCloudCount);
            continue;
        }
        addPointOfLine(text, x, y, cloud);
        ++read;
    }
    if (read < promised)
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
    return cloud.finish();
}

} // namespace bolster
