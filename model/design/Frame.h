// The upholstery frame: a mesh from a file, placed in the design.
#pragma once

#include "Geometry.h"
#include "Message.h"

#include <optional>
#include <string>

namespace bolster {

/// A file point p becomes R(rotation) * (scale * p) + position.
struct Frame {
    std::string name;
    std::string file; ///< relative to the design's folder, never outside it
    double scale = 1; ///< mm per file unit, > 0
    Vec3 position = Vec3::Zero();
    Quat rotation = Quat::Identity();

    Vec3 placed(const Vec3& filePoint) const { return rotation * (scale * filePoint) + position; }

    /// The inverse.
    Vec3 filePoint(const Vec3& placed) const { return fileDirection(placed - position); }
    Vec3 fileDirection(const Vec3& direction) const { return rotation.conjugate() * direction / scale; }

    friend bool operator==(const Frame& a, const Frame& b)
    {
        return a.name == b.name && a.file == b.file && a.scale == b.scale && a.position == b.position &&
               a.rotation.coeffs() == b.rotation.coeffs();
    }
};

/// What is wrong with the name of a frame's file, if anything: it must lie in the design's folder, whatever system
/// the design is opened on. Links on disk are not looked at.
std::optional<Message> frameFileProblem(const std::string& file);

} // namespace bolster
