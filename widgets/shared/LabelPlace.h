// Where the name of a patch is written.
#pragma once

#include "Geometry.h"

#include <QPolygonF>
#include <QSizeF>

#include <optional>
#include <vector>

namespace bolster {

/// The places inside an outline for a line of text: lying, upright, and along the outline if that leans.
class LabelPlace {
public:
    struct Place {
        Vec2 centre = Vec2::Zero(); ///< in the polygon's coordinates
        double angle = 0;           ///< of the line, radians counter-clockwise (y up), -pi/2 to pi/2
        double room = 0;            ///< half the height of the largest line there
    };

    /// Searches on a grid; good enough for a label, about half a millisecond.
    static LabelPlace inside(const QPolygonF& outline);

    /// Where a line of this size (unit of the polygon, length along the line first) stays inside the outline:
    /// as near to its middle as it can be without touching it. Lying, if there is room, else upright, else along.
    std::optional<Place> place(const QSizeF& text) const;
    void move(const Vec2& by);

private:
    /// Nearest to the middle first, each with more room than those before it.
    struct Row {
        double angle = 0;
        double aspect = 3; ///< width to height of the lines that fit
        std::vector<Place> places;
    };

    static void search(const QPolygonF& outline, double angle, std::vector<Row>& rows);

    std::vector<Row> m_rows;
};

} // namespace bolster
