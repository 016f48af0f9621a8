#include "ByteReader.h"
#include "CloudBuilder.h"
#include "CloudReaders.h"
#include "Lzf.h"
#include "TextScanner.h"

#include <bit>
#include <cmath>
#include <optional>

namespace bolster {
namespace {

/// One column, or several of the same name.
struct PcdField {
    std::string name;
    std::uint64_t size = 4; // bytes of one number
    char type = 'F';        // F, I or U
    std::uint64_t count = 1;
};

struct PcdHeader {
    std::vector<PcdField> fields;
    std::uint64_t points = 0;
    std::string data;

    std::uint64_t bytesPerPoint() const
    {
        std::uint64_t sum = 0;
        for (const PcdField& field : fields)
            sum += field.size * field.count;
        return sum;
    }
};

constexpr std::uint64_t mostFields = 1000; // columns of a point, too

[[noreturn]] void refuseHeader(const TextScanner& text, std::string_view word)
{
    refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not expected in a PCD header"),
               {excerpt(word)});
}

/// The words of one line of the header, one for each field.
template <class Take>
void perField(TextScanner& text, PcdHeader& header, Take take)
{
    for (PcdField& field : header.fields) {
        const std::string_view word = text.word();
        if (!take(field, word))
            refuseHeader(text, word);
    }
}

bool takeType(PcdField& field, std::string_view word)
{
    field.type = word.size() == 1 ? word.front() : ' ';
    return field.type == 'F' || field.type == 'I' || field.type == 'U';
}

PcdHeader readHeader(TextScanner& text)
{
    PcdHeader header;
    std::optional<std::uint64_t> width, height, points;
    while (text.nextLine()) {
        const std::string_view key = text.word();
        if (key == "FIELDS" || key == "COLUMNS") {
            for (std::string_view name = text.word(); !name.empty(); name = text.word())
                header.fields.push_back({std::string(name)});
            if (header.fields.size() > mostFields)
                refuseHeader(text, key);
        } else if (key == "SIZE") {
            perField(text, header, [&](PcdField& field, std::string_view word) {
                field.size = text.count(word);
                return field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8;
            });
        } else if (key == "TYPE") {
            perField(text, header, takeType);
        } else if (key == "COUNT") {
            perField(text, header, [&](PcdField& field, std::string_view word) {
                field.count = text.count(word);
                return field.count <= mostFields;
            });
        } else if (key == "WIDTH") {
            width = text.count();
        } else if (key == "HEIGHT") {
            height = text.count();
        } else if (key == "POINTS") {
            points = text.count();
        } else if (key == "DATA") {
            header.data = text.word();
            if (!points && width && height && *width <= largestCloudCount && *height <= largestCloudCount)
                points = *width * *height;
            header.points = points.value_or(0);
            return header;
        } else if (key != "VERSION" && key != "VIEWPOINT") {
            refuseHeader(text, key);
        }
    }
    refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file ends too early"));
}

template <class Reader>
double binaryNumber(Reader& bytes, const PcdField& field)
{
    if (field.type == 'F')
        return field.size == 8 ? bytes.template read<double>() : static_cast<double>(bytes.template read<float>());
    const bool isSigned = field.type == 'I';
    switch (field.size) {
    case 1:
        return isSigned ? bytes.template read<std::int8_t>() : bytes.template read<std::uint8_t>();
    case 2:
        return isSigned ? bytes.template read<std::int16_t>() : bytes.template read<std::uint16_t>();
    case 4:
        return isSigned ? bytes.template read<std::int32_t>() : bytes.template read<std::uint32_t>();
    default:
        break;
    }
    return isSigned ? static_cast<double>(bytes.template read<std::int64_t>())
                    : static_cast<double>(bytes.template read<std::uint64_t>());
}

/// Where x, y and z are among the fields.
std::array<std::size_t, 3> coordinates(const PcdHeader& header)
{
    constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
    std::array<std::size_t, 3> found{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::size_t k = 0;
        while (k < header.fields.size() && header.fields[k].name != names[axis])
            ++k;
        if (k == header.fields.size() || header.fields[k].count != 1 ||
            (header.fields[k].type == 'F' && header.fields[k].size < 4))
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: the points have no coordinate \"%2\""),
                       {std::string(names[axis])});
        found[axis] = k;
    }
    return found;
}

/// Where the colour is: 0xRRGGBB in the bits of a number of four bytes, whatever its type.
std::optional<std::size_t> colorField(const PcdHeader& header)
{
    for (std::size_t k = 0; k < header.fields.size(); ++k)
        if (const PcdField& field = header.fields[k];
            (field.name == "rgb" || field.name == "rgba") && field.size == 4 && field.count == 1)
            return k;
    return std::nullopt;
}

constexpr std::uint32_t colorBits = 0xffffff;

/// Of a number that was written as a text.
std::uint32_t colorOf(double number, const PcdField& field)
{
    if (field.type == 'F')
        return std::bit_cast<std::uint32_t>(static_cast<float>(number)) & colorBits;
    return std::abs(number) <= 4294967295.0
               ? static_cast<std::uint32_t>(static_cast<std::int64_t>(number)) & colorBits
               : 0;
}

void readTextPoints(TextScanner& text, const PcdHeader& header, CloudBuilder& cloud)
{
    const auto axes = coordinates(header);
    const std::optional<std::size_t> colors = colorField(header);
    while (text.nextLine()) {
        Vec3 point;
        std::optional<std::uint32_t> color;
        for (std::size_t k = 0; k < header.fields.size(); ++k)
            for (std::uint64_t i = 0; i < header.fields[k].count; ++i) {
                const std::string_view word = text.word();
                for (int axis = 0; axis < 3; ++axis)
                    if (axes[static_cast<std::size_t>(axis)] == k)
                        point[axis] = text.number(word);
                if (colors == k)
                    color = colorOf(text.number(word), header.fields[k]);
            }
        cloud.addPoint(point, text.place(), color);
    }
}

/// Point by point.
void readBinaryPoints(ByteReader bytes, const PcdHeader& header, CloudBuilder& cloud)
{
    const auto axes = coordinates(header);
    const std::optional<std::size_t> colors = colorField(header);
    bytes.require(header.points, header.bytesPerPoint());
    cloud.reservePoints(header.points, bytes.place());
    for (std::uint64_t i = 0; i < header.points; ++i) {
        const FilePlace place = bytes.place();
        Vec3 point;
        std::optional<std::uint32_t> color;
        for (std::size_t k = 0; k < header.fields.size(); ++k) {
            const auto axis = std::find(axes.begin(), axes.end(), k);
            if (axis != axes.end())
                point[axis - axes.begin()] = binaryNumber(bytes, header.fields[k]);
            else if (colors == k)
                color = bytes.read<std::uint32_t>() & colorBits;
            else
                bytes.skip(header.fields[k].size * header.fields[k].count);
        }
        cloud.addPoint(point, place, color);
    }
}

/// Column by column, so each coordinate is unpacked on its own from where its column begins: nothing is kept.
void readColumns(const FileBytes& file, std::uint64_t start, std::uint64_t packedSize, const PcdHeader& header,
                 CloudBuilder& cloud)
{
    const auto axes = coordinates(header);
    const std::optional<std::size_t> colors = colorField(header);
    std::vector<std::size_t> columns(axes.begin(), axes.end());
    if (colors)
        columns.push_back(*colors);
    std::vector<LzfReader> readers;
    for (const std::size_t wanted : columns) {
        readers.emplace_back(file, start, packedSize);
        for (std::size_t k = 0; k < wanted; ++k)
            readers.back().skip(header.points * header.fields[k].size * header.fields[k].count);
    }
    cloud.reservePoints(header.points, {});
    for (std::uint64_t i = 0; i < header.points; ++i) {
        Vec3 point;
        for (std::size_t axis = 0; axis < 3; ++axis)
            point[static_cast<Eigen::Index>(axis)] = binaryNumber(readers[axis], header.fields[axes[axis]]);
        cloud.addPoint(point, {},
                       colors ? std::optional(readers[3].read<std::uint32_t>() & colorBits) : std::nullopt);
    }
    LzfReader& last = *std::ranges::max_element(readers, {}, &LzfReader::unpacked);
    last.skip(header.points * header.bytesPerPoint() - last.unpacked());
    last.requireEnd();
}

void readCompressed(ByteReader bytes, const FileBytes& file, const PcdHeader& header, CloudBuilder& cloud)
{
    const std::uint64_t packedSize = bytes.read<std::uint32_t>();
    const std::uint64_t size = bytes.read<std::uint32_t>();
    bytes.require(packedSize, 1);
    const FilePlace place = bytes.place();
    const std::uint64_t perPoint = header.bytesPerPoint();
    if (perPoint == 0 || header.points > size / perPoint || size != header.points * perPoint ||
        !lzfMayHold(packedSize, size))
        refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
    readColumns(file, place.number, packedSize, header, cloud);
}

} // namespace

PointCloud readPcd(const FileBytes& bytes)
{
    TextScanner text(bytes);
    const PcdHeader header = readHeader(text);
    CloudBuilder cloud(bytes);
    if (header.data == "ascii")
        readTextPoints(text, header, cloud);
    else if (header.data == "binary")
        readBinaryPoints(ByteReader(bytes, false, text.offsetOfNextLine()), header, cloud);
    else if (header.data == "binary_compressed")
        readCompressed(ByteReader(bytes, false, text.offsetOfNextLine()), bytes, header, cloud);
    else
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a PCD format"),
                   {excerpt(header.data)});
    return cloud.finish();
}

} // namespace bolster
