// A number for each vertex of the cover, shown in colours on cover and pattern: deviations, strains ...
#pragma once

#include "SurfaceMesh.h"

#include <QColor>
#include <QString>

namespace bolster {

/// Colours run from -limit (blue) over 0 (nearly white) to +limit (red).
struct SurfaceMap {
    std::shared_ptr<const SurfaceTopology> topology; ///< of the values
    std::vector<float> values;                       ///< per vertex; NaN: nothing is known, the fabric is shown
    float limit = 1;
    QString title;
    QString below; ///< in words, what negative numbers mean
    QString above;
    QString unit; ///< with the blank before it

    using Rgba = std::array<std::uint8_t, 4>;
    /// Alpha 0 where nothing is known.
    Rgba color(float value) const;
    /// Per vertex.
    std::vector<Rgba> colors() const;
    bool fits(const SurfaceTopology& other) const { return topology && topology->serial == other.serial; }

    /// A round number that most of the values' sizes do not exceed.
    static float usualLimit(double size);
};

using SurfaceMapPtr = std::shared_ptr<const SurfaceMap>;

} // namespace bolster
