#include "ThreeMfUnit.h"

#include "Assembly.h"

#include <algorithm>
#include <cctype>
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

/// Calls `hear` with the attributes of each element that begins so.
class ElementFinder {
public:
    /// `begin`: "<element".
    ElementFinder(std::string_view begin, std::function<void(std::string_view attributes)> hear)
        : m_begin(begin)
        , m_hear(std::move(hear))
    {}

    void take(std::string_view piece)
    {
        m_text += piece;
        std::size_t from = 0;
        for (std::size_t at = m_text.find(m_begin); at != std::string::npos; at = m_text.find(m_begin, from)) {
            const std::size_t end = m_text.find('>', at);
            if (end == std::string::npos && m_text.size() - at < longestElement) {
                m_text.erase(0, at);
                return;
            }
            from = std::min(end, at + m_begin.size());
            if (end != std::string::npos)
                m_hear(std::string_view(m_text).substr(from, end - from));
        }
        m_text.erase(0, m_text.size() - std::min(m_text.size() - from, m_begin.size()));
    }

private:
    static constexpr std::size_t longestElement = 1 << 16;

    std::string m_begin;
    std::function<void(std::string_view)> m_hear;
    std::string m_text; // that has not been looked at yet
};

} // namespace

std::optional<double> threeMfUnit(std::string_view bytes)
{
    constexpr std::pair<std::string_view, double> units[] = {
        {"micron", 1e-3}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}};
    std::optional<double> unit = 1;
    ElementFinder model("<model", [&](std::string_view attributes) {
        const std::string_view said = valueOf(attributes, "unit");
        if (!said.empty())
            unit.reset();
        for (const auto& [word, millimetres] : units)
            if (said == word)
                unit = millimetres;
    });
    unpackModel(bytes, [&model](std::string_view piece) {
        model.take(piece);
        return false; // it is the first element
    });
    return unit;
}

std::map<std::string, std::string, std::less<>> threeMfNames(std::string_view bytes)
{
    std::map<std::string, std::string, std::less<>> names;
    ElementFinder objects("<object", [&](std::string_view attributes) {
        const std::string_view id = valueOf(attributes, "id"), name = valueOf(attributes, "name");
        if (!id.empty() && !name.empty() && names.size() < mostAssemblyParts)
            names.emplace(id, withoutEntities(name.substr(0, longestPartName)));
    });
    unpackModel(bytes, [&objects](std::string_view piece) {
        objects.take(piece);
        return true;
    });
    return names;
}

} // namespace bolster
