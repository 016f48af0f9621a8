// The name by which everything remembered refers to an element: never a pointer, never an index.
#pragma once

#include <cstdint>
#include <functional>

namespace bolster {

/// Positive and unique within a design.
enum class ElementId : std::int32_t {};

/// What no element has: of a reference that refers to nothing, of a search that found nothing.
inline constexpr ElementId noElement{};
/// Of the settings, which every design has.
inline constexpr ElementId settingsId{-1};
inline constexpr std::int32_t largestElementId = 2'000'000'000;

/// As files and messages have it; 0 for the settings.
constexpr std::int32_t number(ElementId id)
{
    return id == settingsId ? 0 : static_cast<std::int32_t>(id);
}

} // namespace bolster
