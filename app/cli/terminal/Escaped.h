// Text from files of anybody, for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace bolster::cli {

enum class Text {
    Line, ///< nothing in it ends a line
    Json  ///< which has lines; its strings mean the same afterwards
};

/// Writes as \u001b and so on what would not be seen but change what is: control characters, those that turn the
/// direction of writing, and separators of lines. In a line bytes that are not UTF-8, too.
std::string escaped(std::string_view text, Text kind);

} // namespace bolster::cli
