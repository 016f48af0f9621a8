// The elements of an SVG file. Private to the library.
#pragma once

#include "FileBytes.h"

#include <map>
#include <string>
#include <vector>

namespace bolster {

struct SvgElement {
    std::string tag; ///< without its namespace
    std::map<std::string, std::string, std::less<>> attributes;
    std::string words; ///< text in it, its children's too
    std::vector<SvgElement> children;

    /// "" where there is none.
    const std::string& attribute(std::string_view name) const;
};

/// Throws FileRefused. Entities are not expanded beyond XML's own five; nothing else is opened.
SvgElement readSvgTree(const FileBytes& bytes);

} // namespace bolster
