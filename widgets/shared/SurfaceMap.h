// A number for each vertex of the cover, shown in colours on cover and pattern: deviations, strains ...
#pragma once

#include "MapScale.h"
#include "SurfaceMesh.h"

#include <QColor>
#include <QString>

namespace bolster {

/// The colours are those of MapScale.
struct SurfaceMap {
    std::shared_ptr<const SurfaceTopology> topology; ///< of the values
    std::vector<float> values;                       ///< per vertex; NaN: nothing is known, the fabric is shown
    std::vector<float> allowed;                      ///< per vertex, for what is over it; empty: anything
    MapScale::Kind kind = MapScale::Kind::Diverging;
    float limit = 1;
    QString title;
    QString below; ///< in words, what negative numbers mean
    QString above;
    QString unit; ///< with the blank before it

    using Rgba = MapScale::Rgba;
    /// Alpha 0 where nothing is known.
    Rgba color(float value) const { return MapScale{kind, limit}.color(value); }
    /// Per vertex.
    std::vector<Rgba> colors() const;
    bool fits(const SurfaceTopology& other) const { return topology && topology->serial == other.serial; }

    /// A round number that most of the values' sizes do not exceed.
    static float usualLimit(double size) { return MapScale::usualLimit(size); }
};

using SurfaceMapPtr = std::shared_ptr<const SurfaceMap>;

} // namespace bolster
