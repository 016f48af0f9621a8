// From where a scene is looked at.
#pragma once

#include "Geometry.h"

namespace bolster {

/// Lengths in mm, angles in radians; z is up.
struct Viewpoint {
    Vec3 target = Vec3::Zero();
    double distance = 2000;   ///< from eye to target
    double azimuth = -0.7;    ///< of the eye about z; 0 is the front (from -y), positive to the right (+x)
    double elevation = 0.35;  ///< of the eye above the horizontal plane, within +-pi/2
    double fieldOfView = 0.6; ///< vertical; it sets the scale at the target for both projections
    bool perspective = true;

    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

} // namespace bolster
