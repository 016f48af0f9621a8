// Edges of outlines that get lengths, several at once. Private to the library.
#pragma once

#include "EdgeTruing.h"
#include "EditHelpers.h"

#include <map>
#include <set>

namespace bolster::edits {

/// Several edges that are to have lengths; those that share a corner pull at it in turn until all have them. Of
/// twins that are alike one stands for both: they have the same parameters, and the other one follows.
class EdgeFit {
public:
    enum class Way {
        Truing,       ///< what lies beside them keeps its shape (truedEdge)
        AboutMiddles, ///< the same, and their middles stay (edgeAboutMiddle)
        Bending       ///< their middles stay, or what is pinned; their neighbours bend
    };

    explicit EdgeFit(const Design& design);

    /// It stays as it is. False when it ends at no corners.
    bool pin(const Stretch& edge);
    /// It ends at corners, so that it can be made longer alone.
    bool takes(const Stretch& edge);
    /// So long (mm) it is to be. False when it ends at no corners.
    bool add(const Stretch& edge, double length);

    /// False when they cannot all have it.
    bool solve(Way way);
    Edit result(const Message& verb) const;

private:
    struct Target {
        Stretch edge;
        double length = 0;
        std::vector<int> points;
    };

    Stretch original(Stretch edge) const;
    std::vector<int> pointsOn(const Stretch& edge);
    bool change(const Target& target, double now, Way way);
    EdgeSurroundings surroundings(const Target& target) const;
    std::optional<BSpline2> scaled(const Target& target, double factor) const;

    const Design& m_design;
    std::map<ElementId, ElementId> m_pairs;
    std::map<ElementId, BSpline2> m_outlines;
    std::set<std::pair<ElementId, int>> m_pinned;
    std::vector<Target> m_targets;
};

/// The control points of an edge, both ends included; all of them where it is the whole outline, none where an end
/// is no corner.
std::vector<int> edgePoints(const BSpline2& outline, const Stretch& edge);
/// Arc length, mm.
double lengthOfEdge(const BSpline2& outline, const Stretch& edge);

} // namespace bolster::edits
