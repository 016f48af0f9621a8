#include "ThreeMfUnit.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <zlib.h>

namespace bolster {
namespace {

constexpr std::size_t lookedAt = 8192; // bytes of the model: its first element says the unit

/// Little-endian, as archives have them; 0 beyond the end.
template <class Number>
std::size_t number(std::string_view bytes, std::size_t at)
{
    Number value = 0;
    if (at <= bytes.size() && bytes.size() - at >= sizeof value)
        std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// Where the entry of the first file with this ending begins, by the archive's directory at its end.
std::size_t entryOf(std::string_view bytes, std::string_view ending)
{
    constexpr std::string_view mark("PK\1\2", 4);
    for (std::size_t at = bytes.find(mark); at != std::string_view::npos; at = bytes.find(mark, at + 4)) {
        const std::size_t length = number<std::uint16_t>(bytes, at + 28);
        const std::string_view name = bytes.size() - at > 46 ? bytes.substr(at + 46, length) : std::string_view();
        if (name.ends_with(ending))
            return number<std::uint32_t>(bytes, at + 42);
    }
    return std::string_view::npos;
}

std::string unpacked(std::string_view bytes, std::size_t entry)
{
    if (bytes.substr(std::min(entry, bytes.size()), 4) != std::string_view("PK\3\4", 4))
        return {};
    const std::size_t start =
        entry + 30 + number<std::uint16_t>(bytes, entry + 26) + number<std::uint16_t>(bytes, entry + 28);
    const std::string_view packed = bytes.substr(std::min(start, bytes.size()), 4 * lookedAt);
    if (number<std::uint16_t>(bytes, entry + 8) == 0)
        return std::string(packed.substr(0, lookedAt));
    std::string plain(lookedAt, '\0');
    z_stream stream = {};
    if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK)
        return {};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data())); // it is only read
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = static_cast<uInt>(plain.size());
    ::inflate(&stream, Z_SYNC_FLUSH);
    plain.resize(plain.size() - stream.avail_out);
    ::inflateEnd(&stream);
    return plain;
}

} // namespace

double threeMfUnit(std::string_view bytes)
{
    constexpr std::pair<std::string_view, double> units[] = {
        {"micron", 1e-3}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}};
    const std::string model = unpacked(bytes, entryOf(bytes, ".model"));
    const std::size_t element = model.find("<model");
    if (element == std::string::npos)
        return 1;
    const std::string_view attributes = std::string_view(model).substr(element, model.find('>', element) - element);
    const std::size_t unit = attributes.find(" unit=");
    if (unit == std::string_view::npos || unit + 8 > attributes.size())
        return 1;
    const std::string_view value = attributes.substr(unit + 7);
    for (const auto& [word, millimetres] : units)
        if (value.starts_with(word))
            return millimetres;
    return 1;
}

} // namespace bolster
