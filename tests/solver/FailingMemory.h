// Memory that runs out when a test wants it to.
#pragma once

#include <cstdint>
#include <thread>

namespace bolster::test {

/// While it lives, the n-th allocation by `new` from its beginning fails, on whatever thread but the spared one.
/// One at a time. Replaces operator new of the whole program.
class FailingMemory {
public:
    explicit FailingMemory(std::int64_t n, std::thread::id spared = {});
    ~FailingMemory();
    FailingMemory(const FailingMemory&) = delete;
    FailingMemory& operator=(const FailingMemory&) = delete;

    /// That have been made since.
    std::int64_t allocations() const;
};

} // namespace bolster::test
