// How much of the sky each place sees: soft shadows that cost nothing while looking around.
#pragma once

#include "Scene.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace bolster {

/// Found beside the GUI thread whenever the cover rests, and kept while it moves.
struct CoverOcclusion {
    /// What stands in the light.
    struct Input {
        SurfaceMeshPtr surface; ///< may be null
        std::vector<Scene::FrameLook> frames;
        float floor = 0; ///< height of the ground
    };
    /// A square raster of the ground, row by row from the lowest y.
    struct Ground {
        Vec2 corner = Vec2::Zero(); ///< lowest x and y, mm
        double side = 1;            ///< mm
        int count = 0;              ///< values along a side
        std::vector<float> open;
    };

    std::uint64_t topology = 0; ///< serial to which `outside` and `inside` belong
    std::vector<float> outside; ///< per vertex, 0 (dark) to 1 (open)
    std::vector<float> inside;  ///< the same for the lining
    Ground ground;

    /// Null when stopped.
    static std::shared_ptr<const CoverOcclusion> of(const Input& input, std::stop_token stop);
};

} // namespace bolster
