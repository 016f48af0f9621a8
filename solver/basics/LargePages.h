// Memory that is read over and over comes sooner from large pages.
#pragma once

#include <cstddef>

namespace bolster {

inline constexpr std::size_t largePage = std::size_t{2} << 20; ///< bytes

/// Asks the system to back this memory with large pages, before it is touched. A wish: where there are none nothing
/// happens. Whole large pages of it count.
void wishLargePages(void* memory, std::size_t bytes);

} // namespace bolster
