// Fair timing of several contestants on a machine that does other things, too.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace bolster::bench {

/// Does a little work and returns how long a unit of it took, ms.
using Lap = std::function<double()>;

/// Laps of a unit of work: as often as takes some milliseconds untimed, because others have had the caches and set
/// the clock since the last lap, then as often again.
Lap repeated(std::function<void()> unit);

double median(std::vector<double> values);

/// Lets everybody run in turns (A B C A B C ...), so that a busy machine hits all alike, until `seconds` are over
/// and everybody has had a few laps. Returns the median of each, ms; nothing when stopped.
std::vector<double> race(std::span<const Lap> laps, double seconds, const std::stop_token& stop);

} // namespace bolster::bench
