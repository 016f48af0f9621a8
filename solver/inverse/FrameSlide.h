// A fixation curve slides along the frame that it lies on.
#pragma once

#include "BSpline.h"
#include "DesignFiles.h"
#include "Frame.h"
#include "TriangleRays.h"

#include <memory>
#include <vector>

namespace bolster {

/// The surface of a frame where it stands, mm.
class FrameSurface {
public:
    struct Place {
        Vec3 point = Vec3::Zero();
        Vec3 normal = Vec3::Zero(); ///< of unit length; zero on a triangle without area
    };

    /// Of its triangles those that meet the box; a frame may have millions.
    FrameSurface(const Frame& frame, const TriangleMesh& mesh, const Box3& within);

    /// The nearest place; nothing when none is within `reach` mm.
    std::optional<Place> nearest(const Vec3& point, double reach) const;

private:
    std::vector<Vec3> m_points;
    std::vector<TriangleRays::Triangle> m_triangles;
    TriangleRays m_tree;
};

/// Ways of a curve's control points along a frame, across the curve.
class FrameSlide {
public:
    /// Null when the curve does not lie on the frame.
    static std::shared_ptr<const FrameSlide> of(const BSpline3& curve, std::shared_ptr<const FrameSurface> frame);

    /// Control points of the curve when it lies `sideways` mm (to the left of its direction, seen from outside)
    /// farther on the frame, as far as no sharp edge is in the way, and `turned` mm farther yet at its end, less at
    /// its start. Each as far from the frame as before.
    std::vector<Vec3> places(double sideways, double turned) const;

private:
    struct Point {
        Vec3 at = Vec3::Zero();
        FrameSurface::Place foot; ///< on the frame
        Vec3 way = Vec3::Zero();  ///< of unit length
        double turn = 0;          ///< -1 at the start of the curve, 1 at its end
    };

    FrameSlide() = default;
    Vec3 walked(const Point& point, double way) const;

    std::vector<Point> m_points;
    std::shared_ptr<const FrameSurface> m_frame;
};

} // namespace bolster
