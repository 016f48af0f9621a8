// The outline on both sides of a dart's mouth. Private to the library.
#pragma once

#include "BezierPieces.h"

#include <optional>

namespace bolster::edits {

/// Of one side, c0 + c1 x + ..., x from 0 to 1 over the mouth.
using Powers = std::array<Vec2, 4>;

/// About one end of a piece, in a unit of `scale` times its length.
Powers powersAt(const BezierPiece<2>& piece, bool end, double scale);

/// Where two sides meet, and how many knots belong there.
struct Meeting {
    double at = 0; ///< of the mouth, 0 to 1
    int knots = 0;
};

/// The outline on both sides of a mouth, as polynomials that go on over it.
class MouthSides {
public:
    /// `span`: of the mouth, in the curve's parameter.
    MouthSides(const BezierPiece<2>& before, const BezierPiece<2>& after, double span);

    /// Where both sides tell what the mouth was before it was cut out.
    std::optional<Meeting> meeting() const;
    /// Whether the outline would go on straight if the mouth were turned shut about this tip: nothing was cut out
    /// there, it was turned open.
    bool turnedOpen(const Vec2& tip) const;
    /// Both sides and the mouth lie on one straight line.
    bool onOneLine() const;
    /// The outline turns to one side, then to the other one over the mouth, by so much that a step is seen.
    bool isStep() const;

    /// From x0 to x1, as a piece of the curve's parameter.
    BezierPiece<2> piece(bool after, double x0, double x1, double from, double span) const;

    Vec2 start() const { return m_before[0]; }
    Vec2 end() const;
    Vec2 startSpeed() const { return m_before[1]; }
    Vec2 endSpeed() const;

private:
    bool isCornerAt(double x) const;
    std::optional<Meeting> smoothMeeting() const;
    std::optional<Meeting> cornerMeeting() const;

    int m_degree;
    Powers m_before;
    Powers m_after;
    Powers m_between; ///< from the one before to the one after
};

} // namespace bolster::edits
