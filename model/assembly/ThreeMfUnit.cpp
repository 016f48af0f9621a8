#include "ThreeMfUnit.h"

#include "Assembly.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>
#include <zlib.h>

namespace bolster {
namespace {

constexpr std::size_t pieceOfModel = 1 << 16; // bytes

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

/// Hands the plain bytes of the model on, a piece at a time, until somebody has had enough of them or they end.
void unpackModel(std::string_view bytes, const std::function<bool(std::string_view)>& hear)
{
    const std::size_t entry = entryOf(bytes, ".model");
    if (bytes.substr(std::min(entry, bytes.size()), 4) != std::string_view("PK\3\4", 4))
        return;
    const std::size_t start =
        entry + 30 + number<std::uint16_t>(bytes, entry + 26) + number<std::uint16_t>(bytes, entry + 28);
    const std::string_view packed = bytes.substr(std::min(start, bytes.size()));
    if (number<std::uint16_t>(bytes, entry + 8) == 0) {
        hear(packed.substr(0, number<std::uint32_t>(bytes, entry + 18)));
        return;
    }
    std::string plain(pieceOfModel, '\0');
    z_stream stream = {};
    if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK)
        return;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data())); // it is only read
    stream.avail_in = static_cast<uInt>(packed.size());
    int state = Z_OK;
    bool more = true;
    while (state == Z_OK && more) {
        stream.next_out = reinterpret_cast<Bytef*>(plain.data());
        stream.avail_out = static_cast<uInt>(plain.size());
        state = ::inflate(&stream, Z_SYNC_FLUSH);
        more = hear(std::string_view(plain).substr(0, plain.size() - stream.avail_out));
    }
    ::inflateEnd(&stream);
}

/// Of an element's attributes, as they are written; "" when it is not there.
std::string_view valueOf(std::string_view attributes, std::string_view name)
{
    for (std::size_t at = attributes.find(name); at != std::string_view::npos; at = attributes.find(name, at + 1)) {
        const std::size_t quote = at + name.size() + 1;
        if (at == 0 || !std::isspace(static_cast<unsigned char>(attributes[at - 1])) ||
            quote >= attributes.size() || attributes[quote - 1] != '=')
            continue;
        const std::size_t end = attributes.find(attributes[quote], quote + 1);
        if (end != std::string_view::npos)
            return attributes.substr(quote + 1, end - quote - 1);
    }
    return {};
}

std::string withoutEntities(std::string_view text)
{
    constexpr std::pair<std::string_view, char> entities[] = {
        {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
    std::string plain;
    while (!text.empty()) {
        std::size_t taken = 1;
        char character = text.front();
        for (const auto& [entity, meant] : entities)
            if (text.starts_with(entity)) {
                taken = entity.size();
                character = meant;
            }
        plain += character;
        text.remove_prefix(taken);
    }
    return plain;
}

/// Calls `hear` with the name of each element that begins, and its attributes.
class ElementFinder {
public:
    using Hear = std::function<void(std::string_view name, std::string_view attributes)>;

    explicit ElementFinder(Hear hear)
        : m_hear(std::move(hear))
    {}

    void take(std::string_view piece)
    {
        m_text += piece;
        std::size_t from = 0;
        for (std::size_t at = m_text.find('<'); at != std::string::npos; at = m_text.find('<', from)) {
            const std::size_t end = m_text.find('>', at);
            if (end == std::string::npos) {
                from = m_text.size() - at < longestElement ? at : m_text.size();
                m_text.erase(0, from);
                return;
            }
            tell(std::string_view(m_text).substr(at + 1, end - at - 1));
            from = end + 1;
        }
        m_text.clear();
    }

private:
    static constexpr std::size_t longestElement = 1 << 16;

    void tell(std::string_view element) const
    {
        const std::size_t end = std::min(element.find_first_of(" \t\r\n/"), element.size());
        m_hear(element.substr(0, end), element.substr(end));
    }

    Hear m_hear;
    std::string m_text; // that has not been looked at yet
};

bool isIndex(std::string_view word)
{
    std::uint32_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    return error == std::errc() && end == word.data() + word.size();
}

/// Adds up how often the build places objects and what they consist of.
class PlacementCounter {
public:
    double placed() const { return m_placed; }

    void object(std::string_view id) { m_object = &m_parts.emplace(id, 1).first->second; }
    void component(std::string_view id)
    {
        if (m_object)
            *m_object += partsOf(id);
    }
    void item(std::string_view id) { m_placed += partsOf(id); }

private:
    /// Objects come before those that consist of them.
    double partsOf(std::string_view id) const
    {
        const auto known = m_parts.find(id);
        return known == m_parts.end() ? 1 : known->second;
    }

    std::map<std::string, double, std::less<>> m_parts; // each object and all below it
    double* m_object = nullptr;                         // that has begun last
    double m_placed = 0;
};

} // namespace

std::optional<double> threeMfUnit(std::string_view bytes)
{
    constexpr std::pair<std::string_view, double> units[] = {
        {"micron", 1e-3}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}};
    std::optional<double> unit = 1;
    bool found = false;
    ElementFinder model([&](std::string_view name, std::string_view attributes) {
        if (found || name != "model")
            return;
        found = true;
        const std::string_view said = valueOf(attributes, "unit");
        if (!said.empty())
            unit.reset();
        for (const auto& [word, millimetres] : units)
            if (said == word)
                unit = millimetres;
    });
    unpackModel(bytes, [&](std::string_view piece) {
        model.take(piece);
        return !found;
    });
    return unit;
}

ThreeMfObjects threeMfObjects(std::string_view bytes)
{
    ThreeMfObjects objects;
    PlacementCounter places;
    ElementFinder elements([&](std::string_view name, std::string_view attributes) {
        if (name == "vertex") {
            objects.hasDecimalCommas |= attributes.find(',') != std::string_view::npos;
        } else if (name == "triangle") {
            for (const std::string_view corner : {"v1", "v2", "v3"})
                objects.hasWrongIndices |= !isIndex(valueOf(attributes, corner));
        } else if (name == "object") {
            const std::string_view id = valueOf(attributes, "id"), given = valueOf(attributes, "name");
            places.object(id);
            if (!id.empty() && !given.empty() && objects.names.size() < mostAssemblyParts)
                objects.names.emplace(id, withoutEntities(given.substr(0, longestPartName)));
        } else if (name == "component") {
            places.component(valueOf(attributes, "objectid"));
        } else if (name == "item") {
            places.item(valueOf(attributes, "objectid"));
        }
    });
    unpackModel(bytes, [&](std::string_view piece) {
        elements.take(piece);
        return places.placed() <= static_cast<double>(mostAssemblyParts);
    });
    objects.placed = places.placed();
    return objects;
}

} // namespace bolster
