// The results of the benchmarks for people.
#pragma once

#include "Benchmarks.h"

namespace bolster::bench {

/// The head of the table on the terminal, and a line of it.
std::string tableHead();
std::string tableLine(const Row& row);

/// docs/performance.md.
std::string markdown(const std::vector<Row>& rows);

} // namespace bolster::bench
