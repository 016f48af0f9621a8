// A piece of the pattern as it lies on the cutting table: values that exports, views and checks share.
#pragma once

#include "CutLine.h"
#include "ElementId.h"
#include "InternalLine.h"
#include "NotchShape.h"
#include "PieceCutting.h"

#include <string>
#include <vector>

namespace bolster {

/// A line inside a piece.
struct PieceLine {
    std::vector<LinePoint> points;
    BSpline2 curve; ///< that the points are of
    bool closed = false;
    bool cut = false; ///< else it is drawn
    ElementId element{};
    std::string name;
};

struct CutNotch {
    Vec2 at = Vec2::Zero();      ///< on the cut line
    Vec2 inwards = Vec2::Zero(); ///< of length 1: to the sewing line
    Vec2 sewn = Vec2::Zero();    ///< where it meets its partner, on the sewing line
    NotchShape shape;
    bool twice = false;
    ElementId element{}; ///< the notch that somebody placed; none: automatic
    ElementId seam{};    ///< whose sides it joins; none: it stands alone
    double fraction = 0; ///< of that seam's first side, where both partners are
};

struct CutHole {
    Vec2 at = Vec2::Zero();
    double diameter = 3; ///< mm
    ElementId element{};
    std::string name;
};

/// The line that lies along the fabric's.
struct GrainLine {
    Vec2 from = Vec2::Zero();
    Vec2 to = Vec2::Zero(); ///< up, where there is one way
    Nap nap = Nap::TwoWays;
};

struct PieceLabel {
    Vec2 at = Vec2::Zero(); ///< of its middle
    double rotation = 0;    ///< of its lines, degrees, counter-clockwise
    double height = 6;      ///< from line to line, mm
    double width = 0;       ///< of its longest line, mm
    bool fits = true;       ///< it lies inside the sewing line
    bool byHand = false;    ///< somebody has put it there
    std::vector<std::string> lines;
};

/// In its outline's coordinates, mm, larger by what the fabric will shrink.
struct CutPiece {
    ElementId patch{};
    std::string name;
    int quantity = 1;
    bool pair = false;     ///< as many again, mirrored
    bool mirrored = false; ///< of a pair as two pieces, the second one
    Nap nap = Nap::TwoWays;
    double tolerance = 2;   ///< degrees, of the grain
    double shrinkAlong = 0; ///< %, along the grain: by so much it is larger here than it will be worn
    double shrinkAcross = 0;
    ElementId fabric{};
    std::string fabricName;
    std::string note; ///< one more line of the label
    /// From the coordinates of its patch's outline to these.
    Eigen::Matrix2d grown = Eigen::Matrix2d::Identity();
    BSpline2 outline;           ///< the sewing line as it was drawn, either way round
    std::vector<LinePoint> sew; ///< counter-clockwise, closed
    std::vector<LinePoint> cut; ///< the same; where all allowances are 0, the sewing line
    std::vector<Vec2> gaps;     ///< where cut lines meet
    std::vector<CutNotch> notches;
    std::vector<CutHole> holes;
    std::vector<PieceLine> inner;
    GrainLine grain;
    PieceLabel label;

    Box2 box() const; ///< of the cut line
    /// In the coordinates of its patch's outline: where it will be when the fabric has shrunk.
    Vec2 shrunk(const Vec2& at) const { return grown.inverse() * at; }
};

/// So many as it is, so many mirrored: "2,2" of a pair.
std::string quantityText(const CutPiece& piece);
/// Inside the closed line, by its winding.
bool isInside(const std::vector<LinePoint>& line, const Vec2& point);
/// From a place to the closed line, mm.
double distanceTo(const std::vector<LinePoint>& line, const Vec2& point);
/// Signed, of the closed line, mm2.
double areaOf(const std::vector<LinePoint>& line);
double lengthOf(const std::vector<LinePoint>& line, bool closed);
/// The other one of a pair: everything mirrored at x = 0.
CutPiece mirroredPiece(CutPiece piece);

/// The line and the heads of its arrow, one at each end that may be up; nothing where it has no length.
std::vector<std::vector<Vec2>> grainLines(const GrainLine& grain);
/// Where it is cut; two places for one that is double.
std::vector<Vec2> notchPoints(const CutNotch& notch);
/// The outline of a notch, from one end at the cut line to the other; two of them for one that is double.
std::vector<std::vector<Vec2>> notchLines(const CutNotch& notch);

} // namespace bolster
