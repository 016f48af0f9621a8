// The name by which everything remembered refers to an element: never a pointer, never an index.
#pragma once

#include <cstdint>
#include <functional>

namespace bolster {

/// Positive and unique within a design; 0 is the settings element, which every design has.
enum class ElementId : std::int32_t {};

inline constexpr ElementId settingsId{0};
inline constexpr std::int32_t largestElementId = 2'000'000'000;

constexpr std::int32_t number(ElementId id)
{
    return static_cast<std::int32_t>(id);
}

} // namespace bolster
