// How lines that are drawn on a form begin and end. Private to the library.
#pragma once

#include "LinePlaces.h"
#include "UncutForm.h"

namespace bolster {

/// mm: what lies farther from the form is no line on it; what is shorter is no line.
inline constexpr double farthestLine = 25, shortestLine = 5;

/// A line that is not refused.
struct LineToCut {
    FormLine line;
    std::vector<Vec3> places = {}; ///< as it goes on to others
    bool isCut = false;            ///< not where it cuts nothing, or not yet
};

/// Of one of several lines: what is drawn a little too far ends on the edge there, what ends a little before a
/// border or another line goes on to there.
class LineEnds {
public:
    /// `spacing` of the places of a line, mm; `own`: its number.
    LineEnds(const UncutForm& form, const std::vector<LineToCut>& lines, std::size_t own, double spacing)
        : m_form(form)
        , m_lines(lines)
        , m_own(own)
        , m_spacing(spacing)
    {}

    /// Of the line between where it runs along borders, which cuts nothing. One that comes back to its beginning is
    /// closed.
    std::vector<FormLine> parts(const FormLine& line) const;

    /// What a line has besides where it runs along edges may be no more than how far it was drawn over their ends;
    /// and where it ends on an edge a little before a border or another line it goes on to there.
    void leadOn(std::vector<LineRun>& runs, const FormLine& line) const;

    /// Whether its ends are on edges that are cut, where it stops.
    using Joined = std::pair<bool, bool>;
    /// On to a border or another line that is near, where it is not outside of the border.
    void prolong(std::vector<Vec3>& places, const FormLine& line, const Joined& joined) const;

private:
    std::vector<FormLine> onForm(const FormLine& line) const;
    FormLine endedOnEdges(FormLine line) const;
    void endOnEdge(std::vector<Vec3>& points) const;
    Vec3 acrossBorder(const Vec3& at) const;
    std::vector<FormLine> awayFromBorder(const FormLine& line) const;
    void leadOn(std::vector<Vec3>& places) const;
    std::pair<bool, bool> trim(std::vector<Vec3>& places, const FormLine& line) const;
    std::optional<Vec3> placeAhead(const Vec3& end, const Vec3& direction) const;
    Vec3 goneOn(const Vec3& end, const Vec3& before) const;

    const UncutForm& m_form;
    const std::vector<LineToCut>& m_lines;
    std::size_t m_own;
    double m_spacing;
};

} // namespace bolster
