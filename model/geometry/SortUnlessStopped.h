// Sorting what may be millions, which ends early when nobody wants it any more.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace bolster {

/// Not stable. When stopped the order means nothing.
template <class Item, class Less>
void sortUnlessStopped(std::vector<Item>& items, const Less& less, const std::stop_token& stop)
{
    constexpr std::size_t block = std::size_t{1} << 16; // some milliseconds
    const std::size_t count = items.size();
    const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(std::min(i, count)); };
    for (std::size_t begin = 0; begin < count && !stop.stop_requested(); begin += block)
        std::sort(at(begin), at(begin + block), less);
    for (std::size_t width = block; width < count; width *= 2)
        for (std::size_t begin = 0; begin + width < count && !stop.stop_requested(); begin += 2 * width)
            std::inplace_merge(at(begin), at(begin + width), at(begin + 2 * width), less);
}

} // namespace bolster
