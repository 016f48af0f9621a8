#include "JsonCharacters.h"

#include <charconv>

namespace bolster::json {

namespace {

// The four hexadecimal digits at the start of the text.
std::optional<unsigned> hexDigits(std::string_view text)
{
    unsigned code = 0;
    if (text.size() < 4)
        return std::nullopt;
    const auto result = std::from_chars(text.data(), text.data() + 4, code, 16);
    return result.ec == std::errc() && result.ptr == text.data() + 4 ? std::optional(code) : std::nullopt;
}

} // namespace

std::size_t sequenceLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto continues = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
        return byte(i) >= low && byte(i) <= high;
    };
    const unsigned first = byte(0);
    if (first < 0x80)
        return 1;
    if (first >= 0xC2 && first <= 0xDF)
        return continues(1) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF)
        return continues(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF) && continues(2) ? 3 : 0;
    if (first >= 0xF0 && first <= 0xF4)
        return continues(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF) && continues(2) &&
                       continues(3)
                   ? 4
                   : 0;
    return 0;
}

void appendUtf8(std::string& text, unsigned code)
{
    const auto put = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | code >> 6);
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | code >> 18);
        put(0x80 | (code >> 12 & 0x3F));
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

std::optional<unsigned> escapedCharacter(std::string_view text, std::size_t& used)
{
    const std::optional<unsigned> first = hexDigits(text);
    used = 4;
    if (!first || (*first >= 0xDC00 && *first <= 0xDFFF))
        return std::nullopt;
    if (*first < 0xD800 || *first > 0xDBFF)
        return first;
    used = 10;
    if (text.substr(4, 2) != "\\u")
        return std::nullopt;
    const std::optional<unsigned> second = hexDigits(text.substr(6));
    if (!second || *second < 0xDC00 || *second > 0xDFFF)
        return std::nullopt;
    return 0x10000 + ((*first - 0xD800) << 10) + (*second - 0xDC00);
}

} // namespace bolster::json
