// Where tests find their files. Functions and no macros of the build: the same test compiles to the same bytes in
// every checkout, so that the compiler cache serves them all.
#pragma once

#include <string>

namespace bolster::test {

/// The checkout.
std::string sourceFolder();
/// resources/samples.
std::string samplesFolder();
/// tests/data.
std::string dataFolder();
/// What pictures are compared with: tests/pictures/golden.
std::string goldenFolder();
/// The built `bolster`; empty where only libraries are built.
std::string program();

} // namespace bolster::test
