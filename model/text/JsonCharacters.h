// The characters of JSON texts. Private to the library.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bolster::json {

/// Length of the UTF-8 sequence at the start of the text, 0 if it is none (RFC 3629: no overlong forms, no
/// surrogates).
std::size_t sequenceLength(std::string_view text);

void appendUtf8(std::string& text, unsigned code);

/// The character of a \u escape, its two halves joined; `text` begins behind the u. `used` becomes the number of
/// characters that belong to it.
std::optional<unsigned> escapedCharacter(std::string_view text, std::size_t& used);

} // namespace bolster::json
