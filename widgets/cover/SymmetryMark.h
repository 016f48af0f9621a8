// The plane that a design is mirrored at, as lines in the 3D view.
#pragma once

#include "Symmetry.h"
#include "ViewScene.h"

namespace bolster {

/// A frame around the scene's box, in the plane, and dashes through its middle. Nothing for an empty scene.
void addSymmetryPlane(const Symmetry& symmetry, ViewScene& scene);

} // namespace bolster
