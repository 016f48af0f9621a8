// Tolerances of making: what varies from piece to piece, and by how much.
#pragma once

#include "Freedom.h"

#include <cstdint>

namespace bolster {

struct Tolerance {
    std::vector<Freedom> freedoms; ///< that vary by the same number, each times its step
    double spread = 1;             ///< of that number: +- so much
    std::string name;
    bool whole = false;         ///< that number is a whole one
    ElementId seam = noElement; ///< whose allowance it is; else it is of what its freedoms are of
};

struct Tolerances {
    std::vector<Tolerance> all;
    bool normal = false;    ///< spread is three standard deviations; else every number within it is as likely
    std::uint64_t seed = 1; ///< another one gives other samples
};

/// Each patch is cut that much larger or smaller all around, mm.
std::vector<Tolerance> cutTolerances(const Design& design, double spread);
/// Each seam is sewn that much farther inside or outside, on both sides, mm.
std::vector<Tolerance> seamTolerances(const Design& design, double spread);
/// Each cushion and foam is that much thicker or thinner, mm; it grows by whole voxels.
std::vector<Tolerance> foamTolerances(const Design& design, double spread);
/// Each fixation curve lies that much elsewhere along each axis, mm.
std::vector<Tolerance> fixationTolerances(const Design& design, double spread);
/// Each fabric is that much stiffer or softer, %.
std::vector<Tolerance> stiffnessTolerances(const Design& design, double spread);
/// Each piece shrinks or stretches by that much, %.
std::vector<Tolerance> sizeTolerances(const Design& design, double spread);

/// The numbers of a sample: they follow from its own number alone, 0 or more.
Eigen::VectorXd sampleOf(const Tolerances& tolerances, std::uint64_t number);
/// The design as that sample has it.
Design sampleDesign(const Design& design, const Tolerances& tolerances, const Eigen::VectorXd& values);

} // namespace bolster
