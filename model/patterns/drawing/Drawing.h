// What is drawn in a file, before anybody asks which of it is a piece of a pattern. In the file's units, y up.
#pragma once

#include "Geometry.h"
#include "Message.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bolster {

/// What is known of a line's direction at a point.
enum class Bend {
    Unknown, ///< a vertex of a polyline: of a polygon, or of somebody's approximation of a curve
    Smooth,  ///< inside an arc, a spline
    Corner
};

struct DrawnPoint {
    Vec2 at = Vec2::Zero();
    Bend bend = Bend::Unknown;
};

struct DrawnLine {
    std::string layer;
    std::vector<DrawnPoint> points; ///< at least two
    bool closed = false;            ///< the first point is not repeated
    double circle = 0;              ///< its radius, of a whole circle; else 0
    std::string called{};           ///< by who drew it; "" without a name
    std::vector<std::string>
        about{}; ///< "KEY: value" of the piece that it belongs to, by those who wrote it for machines
};

/// A POINT: notch, drill hole, turn point or curve point.
struct DrawnDot {
    std::string layer;
    Vec2 at = Vec2::Zero();
    double height = 0;           ///< z: depth of a notch, diameter of a hole; 0: not said
    double thickness = 0;        ///< width of a notch; 0: not said
    std::optional<double> angle; ///< degrees
};

struct DrawnText {
    std::string layer;
    Vec2 at = Vec2::Zero();
    std::string words; ///< UTF-8, one line
};

/// What was drawn together: a block of DXF, everything that is in none.
struct DrawnPart {
    std::string name;
    std::vector<DrawnLine> lines;
    std::vector<DrawnDot> dots;
    std::vector<DrawnText> texts;

    bool empty() const { return lines.empty() && dots.empty() && texts.empty(); }
};

struct Drawing {
    std::vector<DrawnPart> parts;
    std::vector<std::string> texts;     ///< of the whole: "Style Name: Chair"
    std::optional<double> unit;         ///< mm, where the file says it and can be believed
    std::optional<double> usualUnit;    ///< mm, of formats that have one where the file says nothing: SVG's pixels
    std::map<std::string, int> unknown; ///< what could not be read, and how often it is there
    std::vector<Message> notes;         ///< what is odd of the file as a whole
};

} // namespace bolster
