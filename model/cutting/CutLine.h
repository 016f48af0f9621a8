// The line along which a piece is cut: its sewing line and the allowances beyond it.
#pragma once

#include "CutAllowance.h"
#include "OutlineSamples.h"

namespace bolster {

/// A point of a line that is cut or drawn, and whether the line has a corner there ("turn point"; else "curve
/// point").
struct LinePoint {
    Vec2 at = Vec2::Zero(); ///< mm
    bool corner = false;

    friend bool operator==(const LinePoint&, const LinePoint&) = default;
};

/// The sewing line, and the allowance of each of its edges.
struct SewingLine {
    struct Vertex {
        Vec2 at = Vec2::Zero();
        double width = 0; ///< of the edge from here to the next vertex, mm
        bool corner = false;
        CornerJoin join = CornerJoin::Mitred; ///< where it is a corner
    };
    std::vector<Vertex> vertices; ///< counter-clockwise, closed, none twice
};

struct CutLine {
    std::vector<LinePoint> points; ///< counter-clockwise; empty when the sewing line encloses nothing
    std::vector<Vec2> gaps; ///< where the allowance closes up around something that is cut out: cut lines meet
};

/// The boundary of everything that is within the allowance of an edge, on its outer side, and of what joins them at
/// corners. It never crosses itself. Where all allowances are 0 it is the sewing line.
CutLine cutLineOf(const SewingLine& line);

} // namespace bolster
