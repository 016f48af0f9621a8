// Measurements as lines in the pattern.
#pragma once

#include "Design.h"

#include <map>
#include <optional>
#include <set>

namespace bolster {

/// Layout millimetres.
struct PatternMeasure {
    ElementId id{};
    ElementId patch{}; ///< of its beginning
    Vec2 from = Vec2::Zero();
    Vec2 to = Vec2::Zero();
    bool inOnePatch = false; ///< else the way between them is none of the pattern's

    double length() const { return (to - from).norm(); }
};

class PatternMeasures {
public:
    /// Makes those among `owners` anew.
    void update(const Design& design, const std::set<ElementId>& owners);
    const std::map<ElementId, PatternMeasure>& all() const { return m_all; }
    /// The nearest one within `tolerance` (mm) of its line, but not at its ends, which belong to what lies there;
    /// null for none.
    const PatternMeasure* at(const Vec2& place, double tolerance) const;

private:
    std::map<ElementId, PatternMeasure> m_all;
};

} // namespace bolster
