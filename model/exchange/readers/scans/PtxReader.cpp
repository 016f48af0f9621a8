#include "CloudBuilder.h"
#include "CloudReaders.h"
#include "TextScanner.h"

#include <Eigen/Geometry>

#include <array>
#include <charconv>
#include <cmath>

namespace bolster {
namespace {

void nextPtxLine(TextScanner& text)
{
    if (!text.nextLine())
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file ends too early"));
}

/// How many points a scan has, of which the first line has been begun.
std::uint64_t readPtxCount(TextScanner& text)
{
    const std::uint64_t columns = text.count();
    nextPtxLine(text);
    const std::uint64_t rows = text.count();
    constexpr std::uint64_t bytesPerPoint = 8; // at least: four numbers and the blanks between
    if (columns > 0 && rows > text.bytesLeft() / bytesPerPoint / columns)
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
    return columns * rows;
}

/// Position and axes of the scanner say the same as the matrix below them: its rows are what x, y, z and 1 become.
Eigen::Affine3d readPtxMatrix(TextScanner& text)
{
    for (int line = 0; line < 4; ++line) {
        nextPtxLine(text);
        for (int i = 0; i < 3; ++i)
            text.number();
    }
    Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
    for (int row = 0; row < 4; ++row) {
        nextPtxLine(text);
        for (int i = 0; i < 3; ++i)
            matrix(i, row) = text.number();
        text.number();
    }
    const double volume = matrix.linear().determinant();
    if (!matrix.matrix().allFinite() || !(std::abs(volume) > 1e-9))
        refuseFile(text.place(),
                   QT_TRANSLATE_NOOP("Message", "%1: the pose of a scan is no rotation and translation"));
    return matrix;
}

/// Three bytes; without them the brightness, from 0 to 1, as grey.
std::optional<std::uint32_t> readPtxColor(TextScanner& text)
{
    const double brightness = text.number();
    std::uint32_t color = 0;
    for (int i = 0; i < 3; ++i) {
        const std::string_view word = text.word();
        if (word.empty() && i == 0 && brightness >= 0 && brightness <= 1)
            return 0x010101 * static_cast<std::uint32_t>(std::lround(255 * brightness));
        std::uint8_t channel = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), channel);
        if (word.empty() || error != std::errc() || end != word.data() + word.size())
            return std::nullopt;
        color = color << 8 | channel;
    }
    return color;
}

} // namespace

PointCloud readPtx(const FileBytes& bytes)
{
    TextScanner text(bytes);
    CloudBuilder cloud(bytes);
    while (text.nextLine()) {
        const std::uint64_t count = readPtxCount(text);
        const Eigen::Affine3d matrix = readPtxMatrix(text);
        for (std::uint64_t i = 0; i < count; ++i) {
            nextPtxLine(text);
            const double x = text.number(), y = text.number(), z = text.number();
            const std::optional<std::uint32_t> color = readPtxColor(text);
            if (x != 0 || y != 0 || z != 0) // there the scanner has seen nothing
                cloud.addPoint(matrix * Vec3(x, y, z), text.place(), color);
        }
    }
    return cloud.finish();
}

} // namespace bolster
