// A number for each vertex of the cover, shown in colours: deviations, strains ...
#pragma once

#include "MapScale.h"
#include "SurfaceMesh.h"

#include <memory>
#include <vector>

namespace bolster {

/// The colours are those of MapScale.
struct VertexMap {
    std::shared_ptr<const SurfaceTopology> topology; ///< of the values
    std::vector<float> values;                       ///< per vertex; NaN: nothing is known, the fabric is shown
    std::vector<float> allowed;                      ///< per vertex, for what is over it; empty: anything
    MapScale::Kind kind = MapScale::Kind::Diverging;
    float limit = 1;

    using Rgba = MapScale::Rgba;
    /// Alpha 0 where nothing is known.
    Rgba color(float value) const { return MapScale{kind, limit}.color(value); }
    /// Per vertex.
    std::vector<Rgba> colors() const;
    bool fits(const SurfaceTopology& other) const { return topology && topology->serial == other.serial; }
};

using VertexMapPtr = std::shared_ptr<const VertexMap>;

} // namespace bolster
