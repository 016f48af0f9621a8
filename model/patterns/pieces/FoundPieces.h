// The pieces of a pattern that are in a drawing.
#pragma once

#include "Contour.h"
#include "Message.h"
#include "NotchShape.h"
#include "PieceCutting.h"

#include <map>
#include <optional>

namespace bolster {

struct FoundNotch {
    Vec2 at = Vec2::Zero(); ///< on the cut line, or near it
    NotchShape shape;
    bool twice = false;
    std::optional<Vec2> inwards{}; ///< of length 1: from there to the sewing line
};

struct FoundHole {
    Vec2 at = Vec2::Zero();
    double diameter = 0; ///< mm; 0: not said
};

struct FoundLine {
    Contour line;
    bool cut = false;
};

/// Millimetres, as it lies in the file.
struct FoundPiece {
    std::string name;
    std::string size; ///< "" where there is one alone
    std::string fabric;
    std::string note;
    double quantity = 1; ///< whole, at least 1; pairs count as one
    bool pair = false;
    std::string oddQuantity;    ///< what the file says instead of a quantity; "" where it says one, or nothing
    Contour cut;                ///< the cut line, or the only line that there is
    std::optional<Contour> sew; ///< inside of it
    std::vector<Contour> otherSewn{}; ///< smaller sewing lines inside the cut line, beside that one
    bool isCutLine = false;           ///< the file says that the only line is where fabric is cut
    std::optional<double> grain;      ///< degrees
    std::optional<Nap> nap{};
    std::string oddNap;                ///< what the file says of the nap that nobody understands
    std::optional<double> tolerance{}; ///< of the grain, degrees
    std::string shrinkage;             ///< what it is drawn larger for, in the file's words; "" for nothing
    std::vector<FoundNotch> notches;
    std::vector<FoundHole> holes;
    std::vector<FoundLine> inner;
};

struct FoundPattern {
    double unit = 1; ///< mm: what one of the drawing was taken for
    std::string style;
    std::string version;
    std::vector<std::string> sizes;     ///< those that there are, in the file's order
    std::string sampleSize;             ///< what the file calls so; else the first one
    std::vector<FoundPiece> pieces;     ///< of the wanted size
    std::vector<Contour> open;          ///< outlines whose ends do not meet
    int doubled = 0;                    ///< lines that lay twice on themselves
    std::map<std::string, int> outside; ///< what lies in no piece, by layer
    std::map<std::string, int>
        ignored; ///< what is for grading, stripes or mirrors, or nothing is known of, by layer
};

struct PieceOrder {
    double unit = 1;       ///< mm of one of the drawing, > 0
    std::string size;      ///< "": the sample size
    double largestGap = 0; ///< mm: outlines whose ends are no farther apart are closed by a line
};

FoundPattern findPieces(const Drawing& drawing, const PieceOrder& order);

/// What a unit of the drawing is, as far as the file and the size of the pieces tell, mm. What is no sound piece
/// has no say in it.
double guessedUnit(const Drawing& drawing);

} // namespace bolster
