// A body of foam that is added to a cushion, or cut away from it.
#pragma once

#include "ElementId.h"
#include "Placement.h"

#include <string>

namespace bolster {

/// Its place is the middle of the shape, or the origin of the file.
struct Foam : Placement {
    enum class Shape {
        Box,
        Cylinder, ///< about its z axis
        Sphere,
        Mesh ///< from a file
    };

    std::string name;
    ElementId cushion{};
    Shape shape = Shape::Box;
    Vec3 size = Vec3(100, 100, 100); ///< mm at scale 1; of meshes nothing
    std::string file;                ///< of meshes; relative to the design's folder, never outside it
    double dilation = 0;             ///< mm of padding around it
    double strength = 1;             ///< scales the force where it lies
    bool cut = false;
    std::string note = {}; ///< for people

    friend bool operator==(const Foam&, const Foam&) = default;
};

} // namespace bolster
