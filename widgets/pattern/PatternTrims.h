// Stitches and piping as marks in the pattern.
#pragma once

#include "Design.h"

#include <QColor>
#include <QPainterPath>

#include <map>
#include <set>

namespace bolster {

/// A row of stitches or a pipe in a patch.
struct PatternTrim {
    ElementId patch{};
    QPainterPath path; ///< layout, mm
    QColor color;
    double width = 0;  ///< of the thread or the pipe, mm
    double stitch = 0; ///< length of a stitch, mm; 0: a pipe
};

class PatternTrims {
public:
    using Marks = std::multimap<ElementId, PatternTrim>; ///< by the element whose trim it is

    /// Makes those of `owners` anew, and those whose fabric is in `changed`.
    void update(const Design& design, std::set<ElementId> owners, const std::set<ElementId>& changed);
    const Marks& marks() const { return m_marks; }

private:
    void add(const Design& design, ElementId owner);

    Marks m_marks;
};

} // namespace bolster
