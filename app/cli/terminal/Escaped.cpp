#include "Escaped.h"

#include <cstdint>

namespace bolster::cli {
namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t length = 1; ///< bytes; 0: this is not UTF-8
};

Character characterAt(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    if (byte(0) < 0x80)
        return {byte(0), 1};
    const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || at + length > text.size())
        return {byte(0), 0};
    std::uint32_t code = byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80)
            return {byte(0), 0};
        code = code << 6 | (byte(i) & 0x3FU);
    }
    return {code, length};
}

bool isSeen(std::uint32_t code, Text kind)
{
    if (kind == Text::Json && (code == '\n' || code == '\t'))
        return true;
    return code >= 0x20 && !(code >= 0x7F && code < 0xA0) && code != 0x61C && code != 0x200E && code != 0x200F &&
           !(code >= 0x2028 && code <= 0x202E) && !(code >= 0x2066 && code <= 0x2069);
}

void appendEscape(std::string& text, std::uint32_t code)
{
    constexpr std::string_view hex = "0123456789abcdef";
    text += "\\u";
    for (int shift = 12; shift >= 0; shift -= 4)
        text += hex[code >> shift & 15];
}

} // namespace

std::string escaped(std::string_view text, Text kind)
{
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const Character character = characterAt(text, at);
        const std::size_t length = character.length > 0 ? character.length : 1;
        if (character.length == 0 ? kind == Text::Json : isSeen(character.code, kind))
            result += text.substr(at, length);
        else
            appendEscape(result, character.code);
        at += length;
    }
    return result;
}

} // namespace bolster::cli
