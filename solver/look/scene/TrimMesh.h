// Stitches and piping as triangles, to be drawn over the cover.
#pragma once

#include "ElementId.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bolster {

struct TrimMesh {
    /// What looks the same.
    struct Part {
        ElementId element{}; ///< whose trim it is
        std::string color{}; ///< of the thread, or of the pipe's fabric, "#rrggbb"
        ElementId fabric{};  ///< of a pipe; none: thread
        std::uint32_t firstTriangle = 0;
        std::uint32_t triangleCount = 0;
        ElementId patch{}; ///< where it lies
        ElementId other{}; ///< of a pipe in a seam: the patch on its other side
    };

    std::vector<Eigen::Vector3f> points;  ///< mm
    std::vector<Eigen::Vector3f> normals; ///< unit, outwards
    std::vector<Eigen::Vector2f> cloth;   ///< where it lies in piping's fabric, which is cut on the bias, mm
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise seen from the outside
    std::vector<Part> parts;                             ///< one after the other
};

using TrimMeshPtr = std::shared_ptr<const TrimMesh>;

} // namespace bolster
