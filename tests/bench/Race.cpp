#include "Race.h"

#include "Stopwatch.h"

#include <algorithm>

namespace bolster::bench {

Lap repeated(std::function<void()> unit)
{
    return [unit = std::move(unit)] {
        const auto perUnit = [&unit] {
            constexpr double least = 25; // ms: what others left in the caches is gone after some iterations
            const Stopwatch watch;
            int count = 0;
            do {
                unit();
                ++count;
            } while (watch.elapsed() < least);
            return watch.elapsed() / count;
        };
        perUnit();
        return perUnit();
    };
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::vector<double> race(std::span<const Lap> laps, double seconds, const std::stop_token& stop)
{
    constexpr std::size_t fewest = 3;
    std::vector<std::vector<double>> times(laps.size());
    const Stopwatch watch;
    while (times.front().size() < fewest || watch.elapsed() < 1000 * seconds)
        for (std::size_t k = 0; k < laps.size(); ++k) {
            if (stop.stop_requested())
                return {};
            times[k].push_back(laps[k]());
        }
    std::vector<double> medians(laps.size());
    std::transform(times.begin(), times.end(), medians.begin(), median);
    return medians;
}

} // namespace bolster::bench
