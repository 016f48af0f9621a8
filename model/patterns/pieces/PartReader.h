// The pieces of one part of a drawing. Private to the library.
#pragma once

#include "BoxLevels.h"
#include "FoundPieces.h"
#include "LayerRole.h"

#include <set>

namespace bolster {

class PartReader {
public:
    /// Adds to `pattern`. `isSewn`: somewhere in the drawing is a line that is called a sewing line.
    PartReader(const DrawnPart& part, const PieceOrder& order, bool isSewn, FoundPattern& pattern);

    /// `about`: what is known of all pieces of the part.
    void read(FoundPiece about);

private:
    using Lines = std::vector<DrawnLine>;

    void sortLine(const DrawnLine& line);
    Lines* linesFor(LayerRole role);
    std::vector<Contour> joined(Lines& lines, double largestGap);
    std::vector<FoundLine> innerLines();
    void findOutermost(std::vector<Contour> lines, std::vector<Contour>& cut, std::vector<Contour>& sew,
                       std::vector<FoundLine>& inner);
    void moveInner(std::vector<Contour>& cut, std::vector<FoundLine>& inner);
    void makePieces(std::vector<Contour> cut);
    void addSewing(std::vector<Contour> sew, std::vector<FoundLine>& inner);
    void findSewing(std::vector<FoundLine>& inner);
    void markCorners();

    FoundPiece* ownerOf(const Contour& line);
    FoundPiece* ownerOf(const Vec2& at);
    void distribute(std::vector<FoundLine> inner);
    void addGrains();
    void addGrain(FoundPiece& piece, const Vec2& way);
    void addNotches(std::vector<Contour> lines);
    void addNotch(FoundPiece& piece, const FoundNotch& notch, const std::string& layer);
    void addDots();
    void addLabels();

    const DrawnPart& m_part;
    const PieceOrder& m_order;
    bool m_isSewn;
    FoundPattern& m_pattern;
    FoundPiece m_about;
    std::set<LayerRole> m_replaced;
    bool m_saysCut = false;
    std::size_t m_first = 0;
    BoxLevels m_near; ///< boxes of cut lines and what is near them, by their places among all pieces
    std::map<std::ptrdiff_t, double> m_longestGrain;
    Lines m_cut, m_sew, m_unknown, m_notches, m_grain, m_holes, m_internal, m_internalCut;
    std::vector<Contour> m_drawnNotches; ///< of drawings that don't say what they are
};

} // namespace bolster
