// Pulls a point in the layout onto what is near it, and says what that was.
#pragma once

#include "PatternScene.h"
#include "PatternTransform.h"

#include <span>

namespace bolster {

/// Lines across the whole layout that the user has put there, mm.
struct PatternGuides {
    std::vector<double> x; ///< upright ones
    std::vector<double> y; ///< level ones

    friend bool operator==(const PatternGuides&, const PatternGuides&) = default;
};

struct SnapSettings {
    bool on = false;
    bool grid = false; ///< also to the lines of the grid
    PatternGuides guides;
};

/// One reason for the place of a snapped point.
struct SnapHint {
    enum class Kind { Point, Midpoint, Outline, Alignment, Direction, Perpendicular, EqualLength, Guide, Grid };

    Kind kind = Kind::Point;
    Vec2 from = Vec2::Zero(); ///< where a line to the point comes from, layout mm
    Vec2 to = Vec2::Zero();   ///< the point
    double value = 0;         ///< Direction: degrees; EqualLength: mm
};

struct Snapped {
    Vec2 point = Vec2::Zero();
    std::vector<SnapHint> hints; ///< empty: nothing was near
};

/// What is asked: everything in layout mm.
struct SnapQuery {
    Vec2 at = Vec2::Zero();
    std::optional<Vec2> from{};      ///< the edge that ends at the point begins here: directions and lengths count
    std::vector<Vec2> lengthsFrom{}; ///< straight edges that end at the point begin here: only lengths count
    std::optional<Vec2> boxFrom{};   ///< the point is the corner of a box opposite this one: its sides count
    std::optional<Vec2> before{};    ///< and the edge before it here: perpendicular and straight on
    std::vector<Vec2> own{};         ///< points of what is being drawn
    std::set<ElementId> ignored{};   ///< patches that move along
    std::set<std::pair<ElementId, int>> ignoredPoints{}; ///< control points that move along
};

/// A pure function of scene, zoom and settings. Points come first, then the crossing of two lines (outlines,
/// guides, directions, alignments ...), then one line. Everything catches within a few pixels.
class Snapper {
public:
    Snapper(const PatternScene& scene, const PatternTransform& transform, const SnapSettings& settings);

    Snapped snap(const SnapQuery& query) const;
    /// For things that move as one: the way nearest to `delta` that brings one of `points` (where they are before)
    /// onto a point, or in line with one. The hints' ends are where the points come to lie; `point` is the way.
    Snapped snapMove(std::span<const Vec2> points, const Vec2& delta, const std::set<ElementId>& ignored) const;

private:
    struct Rail;

    std::optional<Snapped> toPoint(const SnapQuery& query) const;
    std::vector<Rail> rails(const SnapQuery& query) const;
    void addOutlines(const SnapQuery& query, std::vector<Rail>& rails) const;
    void addDirections(const SnapQuery& query, std::vector<Rail>& rails) const;
    void addAlignments(const SnapQuery& query, std::vector<Rail>& rails) const;
    void addLengths(const SnapQuery& query, std::vector<Rail>& rails) const;
    double lengthNear(const SnapQuery& query, double length) const;
    void addGuides(const SnapQuery& query, std::vector<Rail>& rails) const;
    void addGrid(const SnapQuery& query, std::vector<Rail>& rails) const;

    const PatternScene& m_scene;
    const PatternTransform& m_transform;
    const SnapSettings& m_settings;
    double m_reach;     ///< of points, mm
    double m_lineReach; ///< of lines, mm
};

} // namespace bolster
