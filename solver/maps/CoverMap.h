// Numbers over the cover that say where it suffers: strain, curvature, foam. On the solver's mesh.
#pragma once

#include "Design.h"
#include "DesignFiles.h"
#include "MapScale.h"
#include "SurfaceMesh.h"

#include <optional>
#include <string_view>

namespace bolster {

struct CoverMap {
    enum class Kind {
        Strain,    ///< %: the principal strain of larger size, as in the report
        Along,     ///< %: strain along the patch's grain
        Across,    ///< %: across it
        Shear,     ///< %: tangent of the angle by which warp and weft leave the right angle
        Curvature, ///< 1/m: mean of the two principal ones, positive where the cover bulges outwards
        Thickness, ///< mm: distance to the nearest frame
        Deviation  ///< mm: from a scan, the first that acts; positive where the cover lies outside it
    };

    Kind kind = Kind::Strain;
    std::vector<float> ofVertex; ///< NaN: nothing is known
    std::vector<float> allowed;  ///< of strains: what the vertex's fabric may suffer; else empty
    MapScale scale;

    std::vector<MapScale::Rgba> colors() const;
    float allowedAt(std::uint32_t vertex) const { return allowed.empty() ? 1e30F : allowed[vertex]; }
};

/// A vertex has the value of largest size among the triangles of its patch around it, so that nothing is averaged
/// away: the largest strain is the report's. `surface` must have positions for all of its topology.
CoverMap coverMap(CoverMap::Kind kind, const SurfaceMesh& surface, const Design& design, const DesignFiles& files);

/// "strain", "along", "across", "shear", "curvature", "thickness", "deviation"
std::optional<CoverMap::Kind> coverMapKind(std::string_view word);

struct CoverSpot {
    std::uint32_t vertex = 0;
    float value = 0;
};
/// Where the values are of largest size beside what is allowed, the worst first, no two nearer than `apart` (mm).
std::vector<CoverSpot> worstSpots(const CoverMap& map, const SurfaceMesh& surface, std::size_t most, double apart);

} // namespace bolster
