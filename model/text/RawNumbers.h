// Numbers as files of other programs have them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <string>
#include <type_traits>

namespace bolster {

/// The shortest text that reads back to the same number, whatever the locale: points that are equal are equal as
/// text, too.
template <class Number>
void appendNumber(std::string& text, Number value)
{
    std::array<char, 40> buffer;
    if constexpr (std::is_floating_point_v<Number>)
        value += 0; // "-0" would be another text than "0"
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), end);
}

/// Little-endian.
template <class Number>
void appendRaw(std::string& bytes, Number value)
{
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native == std::endian::big)
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

} // namespace bolster
