#include "JsonText.h"

#include "JsonCharacters.h"

#include <array>
#include <charconv>
#include <cmath>

namespace bolster::json {

Kind Value::kind() const
{
    return m_document->m_nodes[m_index].kind;
}

std::uint32_t Value::next(std::uint32_t index) const
{
    return m_document->m_nodes[index].next;
}

std::string_view Value::source() const
{
    const Document::Node& node = m_document->m_nodes[m_index];
    return m_document->m_text.substr(node.begin, node.end - node.begin);
}

std::optional<double> Value::number() const
{
    if (kind() != Kind::Number)
        return std::nullopt;
    const std::string_view text = source();
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc() ? std::optional(value) : std::nullopt;
}

std::string Value::string() const
{
    std::string text;
    if (kind() != Kind::String)
        return text;
    const std::string_view inside = source().substr(1, source().size() - 2);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (inside[i] != '\\') {
            text += inside[i];
            continue;
        }
        const char c = inside[++i];
        if (c == 'u') {
            std::size_t digits = 0;
            appendUtf8(text, *escapedCharacter(inside.substr(i + 1), digits));
            i += digits;
        } else {
            static constexpr std::string_view names = "bfnrt";
            const std::size_t found = names.find(c);
            text += found == std::string_view::npos ? c : "\b\f\n\r\t"[found];
        }
    }
    return text;
}

std::size_t Value::size() const
{
    std::size_t count = 0;
    eachItem([&](std::size_t, const Value&) { ++count; });
    return count;
}

std::string text(double value)
{
    if (!std::isfinite(value))
        return "null";
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), end.ptr);
}

std::string quoted(std::string_view text)
{
    std::string result = "\"";
    while (!text.empty()) {
        const char c = text.front();
        std::size_t length = sequenceLength(text);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            static constexpr std::string_view hex = "0123456789abcdef";
            result += "\\u00";
            result += hex[static_cast<std::size_t>(c) >> 4];
            result += hex[static_cast<std::size_t>(c) & 15];
        } else if (length == 0) {
            result += "\xEF\xBF\xBD"; // not UTF-8: the replacement character
            length = 1;
        } else {
            result += text.substr(0, length);
        }
        text.remove_prefix(length);
    }
    return result + '"';
}

} // namespace bolster::json
