// A plane that cuts open what the 3D view shows.
#pragma once

#include "Geometry.h"

#include <vector>

namespace bolster {

/// What lies beyond the plane, normal . p > offset, is not shown.
struct SectionPlane {
    Vec3 normal = Vec3::UnitX(); ///< unit, to the side that is cut away
    double offset = 0;           ///< mm

    /// Positive on the side that is kept, mm.
    double height(const Vec3& p) const { return offset - normal.dot(p); }
    bool keeps(const Vec3& p) const { return height(p) >= 0; }

    friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// The parts of a line (mm) that are kept, each with at least two points.
std::vector<std::vector<Eigen::Vector3f>> keptParts(const std::vector<Eigen::Vector3f>& line,
                                                    const SectionPlane& section);
/// The points that are kept.
std::vector<Eigen::Vector3f> keptPoints(const std::vector<Eigen::Vector3f>& points, const SectionPlane& section);
/// From where to where the plane's offset can go while it cuts the box: mm.
std::pair<double, double> sectionRange(const Box3& box, const Vec3& normal);
/// A rectangle around what a plane cuts of a box, and a little more: five points, from the lower left corner on,
/// seen against the unit normal. The box must not be empty.
std::vector<Vec3> planeFrame(const Box3& box, const Vec3& normal, double offset);

} // namespace bolster
