// Small CAD files, written by the library that others write theirs with.
#pragma once

#include <string>

namespace bolster::test {

/// "Chair" holds "Seat" (a red box, 500 x 400 x 50, at z 400), two "Leg"s (cylinders of radius 20, 400 high, at x
/// 50 and 450) and "Back", an assembly of "Rail" alone (a box 500 x 20 x 300, turned by 90 degrees about z, at the
/// origin). `unit`: "MM" or "INCH", of the numbers in the file.
void writeStepChair(const std::string& path, const char* unit = "MM");

/// A box 100 x 200 x 300 as surfaces.
void writeIgesBox(const std::string& path, const char* unit = "MM");

} // namespace bolster::test
