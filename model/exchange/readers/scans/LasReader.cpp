#include "ByteReader.h"
#include "CloudBuilder.h"
#include "CloudReaders.h"

#include <algorithm>
#include <array>

namespace bolster {
namespace {

constexpr std::uint64_t lasHeader = 227;      // bytes, up to version 1.2
constexpr std::uint64_t lasLargeHeader = 375; // of 1.4
constexpr std::uint8_t packedBits = 0xC0;     // in the format: LAZ

/// Of a point format, in bytes from a record's beginning.
struct LasFormat {
    std::uint64_t least = 0; ///< size of a record
    std::uint64_t color = 0; ///< 0: none
};

constexpr std::array<LasFormat, 11> lasFormats = {
    {{20, 0}, {28, 0}, {26, 20}, {34, 28}, {57, 0}, {63, 28}, {30, 0}, {36, 30}, {38, 30}, {59, 0}, {67, 30}}};
constexpr std::uint8_t firstLargeFormat = 6;

struct LasHeader {
    std::uint8_t format = 0;
    std::uint64_t data = 0;   ///< where the points begin
    std::uint64_t record = 0; ///< bytes of a point
    std::uint64_t count = 0;
    Vec3 scale = Vec3::Ones(), offset = Vec3::Zero();
};

void skipTo(ByteReader& reader, std::uint64_t offset)
{
    reader.skip(offset - reader.place().number);
}

Vec3 readVector(ByteReader& reader)
{
    const double x = reader.read<double>(), y = reader.read<double>(), z = reader.read<double>();
    return {x, y, z};
}

void requireLas(ByteReader& reader)
{
    for (const char letter : {'L', 'A', 'S', 'F'})
        if (reader.bytesLeft() < lasHeader - 4 || reader.read<char>() != letter)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 is not a LAS file"));
}

void requireKnownPoints(const LasHeader& header)
{
    if ((header.format & packedBits) != 0)
        refuseFile({},
                   QT_TRANSLATE_NOOP("Message", "%1 is compressed (LAZ), which cannot be read: save it as LAS, for "
                                                "example with laszip or CloudCompare, or as E57"));
    if (header.format >= lasFormats.size() || header.record < lasFormats[header.format].least)
        refuseFile({},
                   QT_TRANSLATE_NOOP("Message", "%1: points of format %2 with %3 bytes cannot be read; save them "
                                                "as LAS 1.2 or 1.4"),
                   {std::to_string(header.format), std::to_string(header.record)});
    if (!header.scale.allFinite() || !header.offset.allFinite() || (header.scale.array() == 0).any())
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: its scale and offset make no points"));
}

LasHeader readLasHeader(ByteReader& reader)
{
    LasHeader header;
    requireLas(reader);
    skipTo(reader, 25);
    const auto minor = reader.read<std::uint8_t>();
    skipTo(reader, 94);
    const std::uint64_t size = reader.read<std::uint16_t>();
    header.data = reader.read<std::uint32_t>();
    skipTo(reader, 104);
    header.format = reader.read<std::uint8_t>();
    header.record = reader.read<std::uint16_t>();
    header.count = reader.read<std::uint32_t>();
    skipTo(reader, 131);
    header.scale = readVector(reader);
    header.offset = readVector(reader);
    requireKnownPoints(header);
    if (minor >= 4 && size >= lasLargeHeader) {
        skipTo(reader, 247);
        if (const auto count = reader.read<std::uint64_t>(); count > 0)
            header.count = count;
    }
    if (header.data < std::max(size, reader.place().number))
        refuseFile(reader.place(),
                   QT_TRANSLATE_NOOP("Message", "%1: the points are said to begin within the header"));
    return header;
}

/// Withheld by whoever has worked on the scan, or found to be noise.
bool isLeftOut(std::uint8_t flags, std::uint8_t classes, bool large)
{
    constexpr std::uint8_t lowNoise = 7, highNoise = 18;
    const bool withheld = large ? (flags & 4) != 0 : (classes & 0x80) != 0;
    const std::uint8_t kind = large ? classes : classes & 0x1f;
    return withheld || kind == lowNoise || kind == highNoise;
}

/// Colours have 16 bits, but many programs write 8: which it is shows when all have been seen. Until one needs
/// more, the lower halves are kept, with a mark.
class LasColors {
public:
    std::uint32_t add(std::uint16_t red, std::uint16_t green, std::uint16_t blue)
    {
        m_large = m_large || (red | green | blue) > 0xff;
        const int shift = m_large ? 8 : 0;
        const auto half = [shift](std::uint16_t channel) { return static_cast<std::uint32_t>(channel >> shift); };
        return half(red) << 16 | half(green) << 8 | half(blue) | (m_large ? 0 : smallMark);
    }

    /// Next to what needs 16 bits, 8 are black.
    void finish(std::vector<std::uint32_t>& colors) const
    {
        for (std::uint32_t& color : colors)
            color = m_large && (color & smallMark) != 0 ? 0 : color & ~smallMark;
    }

private:
    static constexpr std::uint32_t smallMark = 0x1000000;

    bool m_large = false;
};

} // namespace

PointCloud readLas(const FileBytes& bytes)
{
    ByteReader reader(bytes, false);
    const LasHeader header = readLasHeader(reader);
    const LasFormat& format = lasFormats[header.format];
    skipTo(reader, header.data);
    reader.require(header.count, header.record);
    CloudBuilder cloud(bytes);
    cloud.reservePoints(header.count, reader.place());
    LasColors colors;
    for (std::uint64_t i = 0; i < header.count; ++i) {
        const FilePlace place = reader.place();
        const auto x = reader.read<std::int32_t>(), y = reader.read<std::int32_t>(),
                   z = reader.read<std::int32_t>();
        const Vec3 at = Vec3(x, y, z).cwiseProduct(header.scale) + header.offset;
        skipTo(reader, place.number + 15);
        const auto first = reader.read<std::uint8_t>(), second = reader.read<std::uint8_t>();
        const bool large = header.format >= firstLargeFormat;
        std::optional<std::uint32_t> color;
        if (format.color > 0) {
            skipTo(reader, place.number + format.color);
            const auto red = reader.read<std::uint16_t>(), green = reader.read<std::uint16_t>(),
                       blue = reader.read<std::uint16_t>();
            color = colors.add(red, green, blue);
        }
        if (!isLeftOut(first, large ? second : first, large))
            cloud.addPoint(at, place, color);
        skipTo(reader, place.number + header.record);
    }
    PointCloud points = cloud.finish();
    colors.finish(points.colors);
    return points;
}

} // namespace bolster
