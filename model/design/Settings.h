// What holds for the whole design.
#pragma once

namespace bolster {

struct Settings {
    double edgeLength = 12; ///< mean edge of the triangulation, mm, > 0

    friend bool operator==(const Settings&, const Settings&) = default;
};

} // namespace bolster
