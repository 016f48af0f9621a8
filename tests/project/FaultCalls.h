// Calls of the operating system that fail when a test says so.
#pragma once

namespace bolster::test {

/// While it lives, calls of fsync, fdatasync and rename anywhere in this program are counted; number `at` fails
/// with `error`, and all later ones if `lasting`.
class FaultCalls {
public:
    FaultCalls(int at, int error, bool lasting);
    ~FaultCalls();
    FaultCalls(const FaultCalls&) = delete;
    FaultCalls& operator=(const FaultCalls&) = delete;

    bool failed() const;
};

} // namespace bolster::test
