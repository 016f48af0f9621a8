// How a mip-map is made of the next finer one.
#pragma once

#include <algorithm>
#include <cmath>

namespace bolster {

/// The texels of a row that repeats under one of a coarser row, and how much each counts: work(index, share). A
/// tent of twice the texel's width: the mean of a texel alone would turn a weave that is finer than that into a
/// coarser one (moire).
template <class Work>
void eachMipTap(int coarse, int coarseCount, int fineCount, const Work& work)
{
    const float step = static_cast<float>(fineCount) / static_cast<float>(coarseCount);
    const float middle = (static_cast<float>(coarse) + 0.5F) * step;
    const auto share = [&](int i) {
        return std::max(0.F, 1 - std::abs(static_cast<float>(i) + 0.5F - middle) / step);
    };
    const int first = static_cast<int>(std::floor(middle - step)), end = static_cast<int>(middle + step) + 1;
    float sum = 0;
    for (int i = first; i < end; ++i)
        sum += share(i);
    for (int i = first; i < end; ++i)
        if (share(i) > 0)
            work(((i % fineCount) + fineCount) % fineCount, share(i) / sum);
}

} // namespace bolster
