// The header of a PLY file: which elements follow, with which properties.
#pragma once

#include "TextScanner.h"

#include <optional>
#include <string>
#include <vector>

namespace bolster {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::uint64_t byteSize(PlyType type);
bool isInteger(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type{};
    std::optional<PlyType> countType; ///< of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The index of the property with one of these names.
    std::optional<std::size_t> find(std::string_view name, std::string_view otherName = {}) const;
};

struct PlyHeader {
    enum class Format { Text, LittleEndian, BigEndian };

    Format format = Format::Text;
    std::vector<PlyElement> elements;

    const PlyElement* find(std::string_view name) const;
};

/// Leaves the scanner on the line of "end_header". Throws FileRefused.
PlyHeader readPlyHeader(TextScanner& text);

} // namespace bolster
