#include "Lzf.h"

namespace bolster {

std::optional<std::string> unpackLzf(std::string_view packed, std::uint64_t size)
{
    constexpr std::uint64_t largestRatio = 264 / 2; // the longest copy from the fewest bytes
    if (size > packed.size() * largestRatio)
        return std::nullopt;
    std::string result;
    result.reserve(static_cast<std::size_t>(size));
    std::size_t at = 0;
    const auto next = [&]() -> std::size_t { return static_cast<unsigned char>(packed[at++]); };
    while (at < packed.size()) {
        const std::size_t control = next();
        if (control < 32) { // bytes as they are
            const std::size_t count = control + 1;
            if (count > packed.size() - at || count > size - result.size())
                return std::nullopt;
            result.append(packed.substr(at, count));
            at += count;
            continue;
        }
        std::size_t count = (control >> 5) + 2; // a copy of what was there before
        const std::size_t operands = control >> 5 == 7 ? 2 : 1;
        if (operands > packed.size() - at)
            return std::nullopt;
        if (operands == 2)
            count += next();
        const std::size_t back = ((control & 31) << 8) + next() + 1;
        if (back > result.size() || count > size - result.size())
            return std::nullopt;
        for (std::size_t i = 0; i < count; ++i) // may overlap itself
            result.push_back(result[result.size() - back]);
    }
    return result.size() == size ? std::optional(std::move(result)) : std::nullopt;
}

} // namespace bolster
