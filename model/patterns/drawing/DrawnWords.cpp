#include "DrawnWords.h"

#include <QStringDecoder>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace bolster {

namespace {

constexpr std::size_t longestWords = 1000;

void appendUtf8(std::string& text, std::uint32_t c)
{
    if (c < 0x80) {
        text += static_cast<char>(c);
    } else if (c < 0x800) {
        text += static_cast<char>(0xC0 | (c >> 6));
        text += static_cast<char>(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        text += static_cast<char>(0xE0 | (c >> 12));
        text += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        text += static_cast<char>(0x80 | (c & 0x3F));
    } else {
        text += static_cast<char>(0xF0 | (c >> 18));
        text += static_cast<char>(0x80 | ((c >> 12) & 0x3F));
        text += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        text += static_cast<char>(0x80 | (c & 0x3F));
    }
}

/// The length of a well-formed character, and which one; 0 when it is none.
std::size_t utf8Character(std::string_view text, std::uint32_t& c)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    static constexpr std::array<std::uint32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
    const std::size_t length = byte(0) < 0x80             ? 1
                               : (byte(0) & 0xE0) == 0xC0 ? 2
                               : (byte(0) & 0xF0) == 0xE0 ? 3
                               : (byte(0) & 0xF8) == 0xF0 ? 4
                                                          : 0;
    if (length == 0 || length > text.size())
        return 0;
    c = length == 1 ? byte(0) : byte(0) & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80)
            return 0;
        c = (c << 6) | (byte(i) & 0x3F);
    }
    const bool surrogate = c >= 0xD800 && c < 0xE000;
    return c < least[length] || surrogate || c > 0x10FFFF ? 0 : length;
}

/// Bytes of a code page; those that it does not have become question marks in a diamond.
std::string decoded(std::string_view raw, const std::string& codePage)
{
    QStringDecoder decoder(codePage.empty() ? "windows-1252" : codePage.c_str());
    const auto size = static_cast<qsizetype>(raw.size());
    if (!decoder.isValid())
        return QString::fromLatin1(raw.data(), size).toStdString();
    const QString text = decoder(QByteArrayView(raw.data(), size));
    return text.toStdString();
}

/// A cut through the middle of a character is nothing wrong with the rest.
std::string_view wholeCharacters(std::string_view raw)
{
    std::string_view text = raw.substr(0, longestWords);
    if (text.size() < raw.size())
        for (int i = 0; i < 3 && !text.empty() && (raw[text.size()] & 0xC0) == 0x80; ++i)
            text.remove_suffix(1);
    return text;
}

std::string asUtf8(std::string_view raw, const std::string& codePage)
{
    std::uint32_t c = 0;
    for (std::size_t i = 0; i < raw.size();) {
        const std::size_t length = utf8Character(raw.substr(i), c);
        if (length == 0)
            return decoded(raw, codePage);
        i += length;
    }
    return std::string(raw);
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string lowered(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return result;
}

std::string codePageOf(std::string_view dwgName)
{
    const std::string name = lowered(trimmed(dwgName));
    static constexpr std::array<std::pair<std::string_view, const char*>, 5> eastern{{{"ansi_932", "Shift_JIS"},
                                                                                      {"ansi_936", "GBK"},
                                                                                      {"ansi_949", "EUC-KR"},
                                                                                      {"ansi_950", "Big5"},
                                                                                      {"gb2312", "GBK"}}};
    for (const auto& [dwg, other] : eastern)
        if (name == dwg)
            return other;
    if (name.starts_with("ansi_"))
        return std::string("windows-").append(name, 5);
    if (name.starts_with("dos"))
        return std::string("IBM").append(name, 3);
    if (name.starts_with("iso8859-"))
        return std::string("ISO-8859-").append(name, 8);
    return name;
}

std::string drawnWords(std::string_view raw, const std::string& codePage)
{
    const std::string text = asUtf8(wholeCharacters(raw), codePage);
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view rest = std::string_view(text).substr(i);
        std::uint32_t code = 0;
        if (rest.size() >= 7 && rest.starts_with("\\U+") &&
            std::from_chars(rest.data() + 3, rest.data() + 7, code, 16).ptr == rest.data() + 7 && code >= 0x20 &&
            (code < 0xD800 || code >= 0xE000)) {
            appendUtf8(result, code);
            i += 6;
        } else if (rest.starts_with("%%d") || rest.starts_with("%%D")) {
            result += "\u00b0";
            i += 2;
        } else if (static_cast<unsigned char>(text[i]) >= 0x20 && text[i] != 0x7F) {
            result += text[i];
        }
    }
    return result;
}

std::pair<std::string, std::string> keyAndValue(std::string_view words)
{
    const std::size_t colon = words.find(':');
    if (colon == std::string_view::npos || colon == 0 || colon > 40)
        return {{}, std::string(trimmed(words))};
    return {lowered(trimmed(words.substr(0, colon))), std::string(trimmed(words.substr(colon + 1)))};
}

} // namespace bolster
