// Forms laid flat: for each piece the plane shape that the fabric takes with the least strain.
#pragma once

#include "Form.h"

#include <vector>

namespace bolster {

struct FlattenOrder {
    double poisson = 0.3;   ///< of the fabric, within [-0.5, 0.5]
    int mostRounds = 400;   ///< of each of the two passes
    double settled = 0.002; ///< mm: a round that moves no vertex farther ends a pass
};

/// While something moves: nearly right, soon.
inline constexpr FlattenOrder draftFlattening{0.3, 40, 0.05};

struct FlatPiece {
    std::vector<Vec2> at;  ///< of each vertex of the piece, mm; counter-clockwise as the piece seen from outside
    double strainRms = 0;  ///< of the cloth when it lies on the form, both directions, weighted by area; 1
    double strainP99 = 0;  ///< size of a principal strain that 99 % of the area do not exceed; 1
    double strainMost = 0; ///< largest size of a principal strain; 1
    Vec3 strainedAt = Vec3::Zero(); ///< where that is, on the form
    std::vector<float> strain;      ///< of each triangle: that size; 1
    int turnedOver = 0;             ///< triangles
    double turnedShare = 0;         ///< of the area
    double area = 0;                ///< mm^2
};

/// Roles of rest and state swapped in the sheet's energy: on the given form the plane shape is sought whose sheet,
/// with the fabric's Poisson number, is strained least. Alternates between the nearest rotation of each triangle
/// and one prefactored system for each piece. Edges that are sewn to each other become equally long, by their
/// common mean. Begins with the conformal map of least squares (Levy et al., "Least squares conformal maps", 2002).
/// Turned so that what points up on the form points to +y; where it lies flat, what points to the back (+y). When
/// stopped it means nothing.
std::vector<FlatPiece> flatten(const Form& form, const FlattenOrder& order, const std::stop_token& stop = {});

} // namespace bolster
