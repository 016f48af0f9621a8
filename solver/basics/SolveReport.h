// What a solve did, in numbers.
#pragma once

#include "Problem.h"
#include "ScanFigures.h"

#include <cstdint>
#include <vector>

namespace bolster {

/// Lengths in mm. docs/command-line.md explains each.
struct SolveReport {
    std::int64_t vertices = 0; ///< after merging sewn ones
    std::int64_t triangles = 0;
    std::int64_t patches = 0;
    std::int64_t seams = 0;

    struct Constraints {
        std::int64_t fixed = 0;       ///< merged vertices held by fixation curves and handles
        std::int64_t sewn = 0;        ///< pairs of vertices
        std::int64_t orientation = 0; ///< rows
        std::int64_t ghost = 0;       ///< rows
    } constraints;

    int iterations = 0;
    double movement = 0; ///< of the last iteration, relative to D
    struct MaxMean {
        double max = 0;
        double mean = 0;
    };
    MaxMean seamGap;
    MaxMean fixationError;        ///< at vertices
    double fixationDeviation = 0; ///< largest distance of the curve from the fixed outline between vertices
    struct OfElement {
        ElementId element{};
        double value = 0;
    };
    std::vector<OfElement> handles;    ///< largest distance of a vertex from its point on the target
    std::vector<OfElement> fancySeams; ///< depth that is reached
    struct Strain {
        double max = 0; ///< of |principal stretch - 1|
        double p99 = 0;
        double rms = 0; ///< area-weighted, over both principal stretches
    } strain;
    double area = 0;                   ///< mm^2
    double restArea = 0;               ///< mm^2
    std::int64_t flippedTriangles = 0; ///< normal more than 90 degrees from the mean of its frames' normals

    /// Of each cushion and each frame with contact that acts on the cover.
    struct Cushion {
        ElementId element{};
        std::int64_t voxels = 0;   ///< inside of the cushioning, over all sewn components
        std::int64_t vertices = 0; ///< that are pushed
        MaxMean push;              ///< of these: the force f, mm
    };
    std::vector<Cushion> cushions;

    struct ScanFit {
        ElementId scan{};
        std::string name;
        ScanFigures figures;
    };
    std::vector<ScanFit> scans;

    struct Times {
        double triangulate = 0;
        double assemble = 0;
        double factor = 0;
        double iterate = 0;
        double perIteration = 0;
        double total = 0;
    } time; ///< milliseconds
};

} // namespace bolster
