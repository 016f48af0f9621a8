// Gives up all that a process does not need to compute. For the programs that read files of unknown origin, and
// their tests.
#pragma once

#include <span>

namespace bolster {

/// From here on this process can compute, read what it has open, write to its standard output and error and to
/// `kept`, and end. Opening files, sockets, starting programs, threads and processes, and whatever else there is
/// fails with EPERM. What is open beside the three standard files and `kept` is closed. False when that cannot be
/// had; there is no way back.
bool enterSandbox(std::span<const int> kept = {});

} // namespace bolster
