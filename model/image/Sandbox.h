// Gives up all that a process does not need to compute. A library of its own, for the picture decoder and its
// tests.
#pragma once

namespace bolster {

/// From here on this process can compute, read what it has open, write to its standard output and error, and end.
/// Opening files, sockets, starting programs, threads and processes, and whatever else there is fails with EPERM.
/// What is open beside the three standard files is closed. False when that cannot be had; there is no way back.
bool enterSandbox();

} // namespace bolster
