// Words of drawings, as strangers write them. Private to the library.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace bolster {

/// Without blanks around it.
std::string_view trimmed(std::string_view text);
std::string lowered(std::string_view text);
/// What a code page of DXF ("ANSI_1251", "dos850") is called elsewhere.
std::string codePageOf(std::string_view dwgName);
/// UTF-8 of UTF-8 or else of a code page (Western European without one), with what DXF writes in ASCII decoded:
/// \U+00FC, %%d.
std::string drawnWords(std::string_view raw, const std::string& codePage = {});
/// "Piece Name: Seat" is ("piece name", "Seat"); the first is empty where there is no colon.
std::pair<std::string, std::string> keyAndValue(std::string_view words);

} // namespace bolster
