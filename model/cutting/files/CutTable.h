// Pieces side by side on one surface: for files without pages, and for the pages of others.
#pragma once

#include "CutPattern.h"

namespace bolster {

/// Where a piece lies on the table; its own coordinates are turned, then moved.
struct TablePiece {
    std::size_t piece = 0; ///< of the pattern
    double angle = 0;      ///< radians, counter-clockwise
    Vec2 offset = Vec2::Zero();

    Vec2 at(const Vec2& point) const { return Eigen::Rotation2Dd(angle) * point + offset; }
};

struct CutTable {
    std::vector<TablePiece> pieces; ///< in the order in which a pen has little way between them
    Vec2 size = Vec2::Zero();       ///< from 0, mm
};

/// By which a piece is turned so that its grain runs up, radians.
double uprightAngle(const CutPiece& piece);
/// Of both lines of the piece turned so.
Box2 turnedBox(const CutPiece& piece, double angle);

/// Of files without pages, mm.
inline constexpr double usualTableWidth = 3000;

/// In rows, with their grain upright, 20 mm apart. A row is at most `width` (mm) long, but for a piece that is
/// wider.
CutTable arranged(const CutPattern& pattern, double width);

} // namespace bolster
