// An outline as a fine polygon: what lies inside it, and where lines meet it.
#pragma once

#include "BSpline.h"

#include <optional>
#include <vector>

namespace bolster {

class PatchBorder {
public:
    /// A point where a line meets the outline.
    struct Meeting {
        double fraction = 0;  ///< along the line, 0 to 1
        double parameter = 0; ///< on the outline
    };

    /// `step` (mm) is about the length of the polygon's edges. The outline must outlive it.
    PatchBorder(const BSpline2& outline, double step);

    const BSpline2& outline() const { return *m_outline; }
    const std::vector<Vec2>& points() const { return m_points; }
    Box2 box() const;
    bool contains(const Vec2& p) const;
    /// Where the line from a to b first meets the outline.
    std::optional<Meeting> firstMeeting(const Vec2& a, const Vec2& b) const;

private:
    void sortIntoRows(double step);
    std::size_t rowAt(double y) const;

    const BSpline2* m_outline;
    std::vector<double> m_parameters; // one more than points: the last is the domain's end
    std::vector<Vec2> m_points;
    // Which edges of the polygon lie at which height: those of one row of many.
    double m_low = 0;       // mm
    double m_rowHeight = 1; // mm
    std::vector<std::vector<int>> m_rows;
};

} // namespace bolster
