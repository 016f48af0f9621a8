// Points measured on a surface that the cover is fitted to (paper, section 5).
#pragma once

#include "Placement.h"

#include <string>
#include <vector>

namespace bolster {

/// Where a vertex is pulled by the point that is nearest to it.
enum class ScanTarget {
    Plane, ///< along the cover's normal only, so that cloth can slide under the points
    Point  ///< to the point itself, as in the paper
};

/// Half of space: points p of the scan's file with normal . p <= distance.
struct HalfSpace {
    Vec3 normal = Vec3::UnitZ(); ///< any length but 0
    double distance = 0;         ///< file units times the normal's length

    bool contains(const Vec3& filePoint) const { return normal.dot(filePoint) <= distance; }

    friend bool operator==(const HalfSpace&, const HalfSpace&) = default;
};

/// A convex region of a scan that does not belong to the cover: floor, walls, people.
struct ScanCut {
    std::vector<HalfSpace> halfSpaces; ///< the region is what they have in common
    bool keep = false;                 ///< cuts away what lies outside instead

    bool removes(const Vec3& filePoint) const;

    friend bool operator==(const ScanCut&, const ScanCut&) = default;
};

struct Scan : Placement {
    std::string name;
    std::string file;      ///< relative to the design's folder, never outside it
    double threshold = 60; ///< mm: vertices further than this from every point are not pulled
    double strength = 1;   ///< of the pull, 0 to 100
    bool enabled = true;   ///< false: only measured against
    ScanTarget target = ScanTarget::Plane;
    std::vector<ScanCut> cuts; ///< in the scan's file, so that they go where it goes
    std::string note = {};     ///< for people

    /// Whether some cut removes the point.
    bool isCutAway(const Vec3& filePoint) const;

    friend bool operator==(const Scan&, const Scan&) = default;
};

} // namespace bolster
