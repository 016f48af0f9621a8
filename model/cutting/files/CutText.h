// Numbers and words as files for cutters have them. Private to the library.
#pragma once

#include "CutPiece.h"

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace bolster {

/// With a point and at most so many decimals, whatever the language; "0" for what is nearly that.
inline std::string decimal(double value, int decimals = 4)
{
    char text[64];
    const auto end = std::to_chars(std::begin(text), std::end(text), value, std::chars_format::fixed, decimals).ptr;
    std::string result(text, end);
    if (result.find('.') != std::string::npos) {
        result.erase(result.find_last_not_of('0') + 1);
        if (result.back() == '.')
            result.pop_back();
    }
    return result == "-0" ? "0" : result;
}

/// Which ways round the piece may lie; empty for either end up, as it is without a word.
inline std::string napText(const CutPiece& piece)
{
    return piece.nap == Nap::OneWay ? "ONE WAY" : piece.nap == Nap::Any ? "ANY WAY" : "";
}

/// How far its grain may be off, degrees; empty for as much as usual.
inline std::string toleranceText(const CutPiece& piece)
{
    return piece.tolerance == PieceCutting{}.tolerance ? std::string() : decimal(piece.tolerance);
}

/// What the fabric shrinks by, along and across the grain; empty for not at all.
inline std::string shrinkageText(const CutPiece& piece)
{
    if (piece.shrinkAlong == 0 && piece.shrinkAcross == 0)
        return {};
    return decimal(piece.shrinkAlong) + " % along, " + decimal(piece.shrinkAcross) + " % across";
}

/// ASCII, for formats that know nothing else: letters of Western Europe lose their marks, others become "_".
inline std::string ascii(std::string_view text)
{
    static constexpr std::string_view plain =
        "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo-ouuuuyty"; // U+00C0 to U+00FF
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x80) {
            result += byte < 0x20 || byte == 0x7F ? ' ' : text[i];
        } else if (byte == 0xC3 && i + 1 < text.size()) {
            const auto next = static_cast<unsigned char>(text[++i]);
            result += next >= 0x80 && next < 0xC0 ? plain[next - 0x80] : '_';
        } else {
            while (i + 1 < text.size() && (static_cast<unsigned char>(text[i + 1]) & 0xC0) == 0x80)
                ++i;
            result += '_';
        }
    }
    return result;
}

/// ASCII from which DXF readers get the text back: \U+ and four digits for all else.
inline std::string escapedAscii(std::string_view utf8)
{
    std::string result;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto byte = static_cast<unsigned char>(utf8[i++]);
        unsigned code = byte < 0x80 ? byte : byte < 0xE0 ? byte & 0x1Fu : byte < 0xF0 ? byte & 0x0Fu : 0;
        while (i < utf8.size() && (static_cast<unsigned char>(utf8[i]) & 0xC0) == 0x80)
            code = code << 6 | (static_cast<unsigned char>(utf8[i++]) & 0x3Fu);
        if (byte < 0x80) {
            result += byte < 0x20 || byte == 0x7F ? ' ' : static_cast<char>(byte);
        } else if (byte < 0xF0) {
            result += "\\U+";
            for (const unsigned shift : {12u, 8u, 4u, 0u})
                result += "0123456789ABCDEF"[code >> shift & 15];
        } else {
            result += '_'; // beyond what DXF can say
        }
    }
    return result;
}

} // namespace bolster
