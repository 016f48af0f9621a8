// The tables of fields in docs/design-json.md, from the descriptions of the kinds.
#pragma once

#include <string>

namespace bolster {

/// The document with each table anew that stands between "<!-- fields of NAME -->" and "<!-- end -->"; NAME is a
/// kind as the text form calls it, or settings, look, trim, stretch, twin or symmetry. What has another name stays.
std::string withFieldTables(const std::string& document);

} // namespace bolster
