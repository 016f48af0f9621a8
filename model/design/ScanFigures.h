// How well a cover lies on a scan, in numbers.
#pragma once

#include <cstdint>

namespace bolster {

/// Of the deviations along the cover's normals, weighted by area. mm.
struct ScanFigures {
    std::int64_t points = 0; ///< that are not cut away
    double rms = 0;
    double median = 0; ///< of their sizes, as the next two
    double p95 = 0;
    double max = 0;
    double coverage = 0; ///< share of the cover's area that the scan has points for

    friend bool operator==(const ScanFigures&, const ScanFigures&) = default;
};

} // namespace bolster
