// One piece of a pattern as elements of a design. Private to the library.
#pragma once

#include "Design.h"
#include "FoundPieces.h"
#include "PatternDesign.h"

namespace bolster {

/// Free ids, one after the other.
class FreshIds {
public:
    explicit FreshIds(const Design& design)
        : m_design(design)
        , m_next(design.nextId())
    {}

    ElementId operator()()
    {
        const ElementId id = m_next;
        do
            m_next = ElementId(number(m_next) < largestElementId ? number(m_next) + 1 : 1);
        while (m_design.elements().contains(m_next));
        return id;
    }

private:
    Design m_design;
    ElementId m_next;
};

/// A patch at the place of its piece in the file and what lies on it; each refers to nothing else but the fabric.
struct PieceElements {
    ElementId patch = noElement; ///< none: the piece is left out
    std::vector<Change> changes;
    std::vector<Message> notes; ///< what was left out, or made otherwise
};

PieceElements pieceElements(const FoundPiece& piece, PatternLines lines, const Change& fabric, FreshIds& fresh);

} // namespace bolster
