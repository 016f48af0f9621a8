// LAS files as tests need them, written from the standard's text.
#pragma once

#include "Geometry.h"
#include "TestFiles.h"

#include <array>
#include <optional>
#include <vector>

namespace bolster::test {

struct LasWriter {
    int minor = 2;
    int format = 0;
    int surplus = 0; ///< bytes behind each point
    std::vector<std::array<std::int32_t, 3>> points{};
    std::vector<std::array<std::uint16_t, 3>> colors{};
    std::vector<int> classes{};
    int withheld = -1;
    Vec3 scale{0.01, 0.001, 0.001}, offset{500, 2, 10};
    std::optional<std::uint64_t> count{};
    std::optional<std::uint32_t> dataOffset{};

    std::string file() const
    {
        const std::size_t header = minor == 4 ? 375 : minor == 3 ? 235 : 227;
        constexpr std::size_t records = 20; // some record that does not matter
        std::string body;
        for (std::size_t i = 0; i < points.size(); ++i)
            body += record(i);
        const std::uint64_t n = count.value_or(points.size());
        std::string bytes = "LASF" + std::string(20, '\0');
        bytes += '\1';
        bytes += static_cast<char>(minor);
        bytes.resize(94, ' ');
        append(bytes, static_cast<std::uint16_t>(header));
        append(bytes, dataOffset.value_or(static_cast<std::uint32_t>(header + records)));
        append(bytes, std::uint32_t{0});
        bytes += static_cast<char>(format);
        append(bytes, static_cast<std::uint16_t>(points.empty() ? 20 : body.size() / points.size()));
        append(bytes, minor == 4 && format > 5 ? 0U : static_cast<std::uint32_t>(n));
        bytes.resize(131);
        for (const Vec3& vector : {scale, offset})
            for (const double number : vector)
                append(bytes, number);
        bytes.resize(247);
        append(bytes, n);
        bytes.resize(header + records);
        return bytes + body;
    }

private:
    std::string record(std::size_t i) const
    {
        constexpr std::array<std::size_t, 11> sizes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
        constexpr std::array<std::size_t, 11> colorAt = {0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30};
        const std::size_t kind = static_cast<std::size_t>(format) % 64 % sizes.size();
        const bool large = kind >= 6;
        const int kindOfPoint = classes.empty() ? 2 : classes[i];
        const bool isWithheld = static_cast<int>(i) == withheld;
        std::string bytes;
        for (const std::int32_t number : points[i])
            append(bytes, number);
        append(bytes, std::uint16_t{1234});
        bytes += large ? '\x11' : '\x49';
        if (large)
            bytes += isWithheld ? '\4' : '\0';
        bytes += static_cast<char>(kindOfPoint | (isWithheld && !large ? 0x80 : 0));
        bytes.resize(sizes[kind], '\x55');
        if (colorAt[kind] > 0) {
            std::string color;
            for (const std::uint16_t channel : colors.empty() ? std::array<std::uint16_t, 3>{} : colors[i])
                append(color, channel);
            bytes.replace(colorAt[kind], color.size(), color);
        }
        return bytes + std::string(static_cast<std::size_t>(surplus), '\x33');
    }
};

} // namespace bolster::test
