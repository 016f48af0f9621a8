// Which points lie on an outline, and where. Private to the library.
#pragma once

#include "BezierPieces.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace bolster::edits {

/// How far (mm) a point of a drawn curve may be from the outline and still lie on it: less than anybody can see or
/// cut, more than files and turning round off.
inline constexpr double onOutline = 0.01;

/// Made once for many points: most of them are far from any span.
class OutlinePlaces {
public:
    OutlinePlaces(const BSpline2& outline)
        : m_outline(outline)
    {
        for (const BezierPiece<2>& piece : bezierPieces(outline)) {
            Box2 box;
            for (int i = 0; i <= piece.degree; ++i)
                box.extend(piece.points[static_cast<std::size_t>(i)]);
            m_boxes.push_back(box);
        }
    }

    /// Of the outline; nothing for a point that does not lie on it.
    std::optional<double> parameter(const Vec2& point) const
    {
        const auto near = [&](const Box2& box) { return box.exteriorDistance(point) <= onOutline; };
        if (std::none_of(m_boxes.begin(), m_boxes.end(), near))
            return std::nullopt;
        const BSpline2::Closest closest = m_outline.closest(point);
        return closest.distance <= onOutline ? std::optional(closest.parameter) : std::nullopt;
    }

private:
    BSpline2 m_outline;
    std::vector<Box2> m_boxes;
};

} // namespace bolster::edits
