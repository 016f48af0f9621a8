// How fast memory can be read: the floor of everything that reads a factor.
#pragma once

#include "WorkerPool.h"

#include <functional>

namespace bolster::bench {

/// Reads an array of so many bytes once, each thread its own part.
std::function<void()> readOf(std::size_t bytes, WorkerPool& pool);

} // namespace bolster::bench
