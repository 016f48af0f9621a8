// Numbers as files of other programs have them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <string>
#include <type_traits>

namespace bolster {

/// Little-endian.
template <class Number>
void appendRaw(std::string& bytes, Number value)
{
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native == std::endian::big)
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

/// The shortest text that reads back to the same number, whatever the locale; "-0" is "0".
template <class Number>
void appendText(std::string& text, Number value)
{
    std::array<char, 40> buffer;
    if constexpr (std::is_floating_point_v<Number>)
        value += 0;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), end);
}

} // namespace bolster
