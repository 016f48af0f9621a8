// Where the vertices on the outlines lie, so that sewn stretches match one to one (paper, section 3.2), and those
// on the curves drawn inside.
#pragma once

#include "Design.h"
#include "PatchTriangulator.h"

#include <memory>

namespace bolster {

/// The samples of all outlines, the pairs along seams and the targets along fixations. No triangulation yet.
///
/// Outlines are cut at corners and stretch ends, cuts are carried across the seams, and the pieces between cuts are
/// divided into edges of about the design's edge length, as many on each side of a seam. Lines that end at an
/// outline cut it there.
struct OutlineSampling {
    /// A handle curve, or one of the parallel lines of a fancy seam.
    struct Line {
        ElementId element{};
        InnerLine shape;
        std::vector<double> fractions; ///< of a handle curve: where on its target each point belongs
        double across = 0;             ///< of a fancy seam: -1 and 1 are the outer lines
    };
    struct Outline {
        ElementId patch{};
        std::vector<double> parameters; ///< increasing, within one period from the domain's start
        std::vector<Vec2> points;       ///< outline coordinates, mm
        std::vector<int> cluster;       ///< sewn samples share one
        std::vector<Line> lines;        ///< inside
    };
    struct SewnChain {
        ElementId seam{};
        int outlineA = 0; ///< index into `outlines`
        int outlineB = 0;
        std::vector<int> a; ///< sample indices along stretch a; a[k] is sewn to b[k]
        std::vector<int> b;
    };
    struct FixedChain {
        ElementId fixation{}; ///< a FixationSeam, or the handle curve
        ElementId curve{};    ///< a FixationCurve, or the handle curve
        int outline = 0;
        int line = -1; ///< of the outline's lines, for a handle; else -1, and
        std::vector<int> samples;
        std::vector<double> curveParameters; ///< where on the curve each sample belongs
        std::vector<Vec3> targets;           ///< mm
    };

    struct OrientedChain {
        ElementId owner{}; ///< a FixationSeam, or a handle curve
        int outline = 0;
        int line = -1; ///< of the outline's lines, for a handle; else -1, and
        std::vector<int> samples;
        std::vector<Vec3> directions; ///< unit, or zero, per sample
        Orientation::Kind kind = Orientation::Kind::Normal;
        double weight = 1;
    };

    std::vector<Outline> outlines; ///< by increasing patch id
    std::vector<SewnChain> seams;
    std::vector<FixedChain> fixations;
    std::vector<FixedChain> handles;
    std::vector<OrientedChain> orientations;
    int clusterCount = 0;
    Problems problems; ///< seams that cannot be matched, two targets for one vertex ...
};

/// The design must be free of errors (usablePart).
OutlineSampling sampleOutlines(const Design& design);

/// Targets and directions again after fixation curves, targets of handles or directions have changed, the samples
/// being kept.
void retarget(OutlineSampling& sampling, const Design& design);

/// All points again after outlines and curves in them have been reshaped, as many and in the same order. False when
/// that cannot be; the sampling is of no use then.
bool resample(OutlineSampling& sampling, const Design& design);

} // namespace bolster
