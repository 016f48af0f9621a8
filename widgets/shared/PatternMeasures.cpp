#include "PatternMeasures.h"

#include <algorithm>

namespace bolster {

namespace {

double distanceToLine(const PatternMeasure& measure, const Vec2& place)
{
    const Vec2 way = measure.to - measure.from;
    const double length = way.squaredNorm();
    const double share = length > 0 ? std::clamp((place - measure.from).dot(way) / length, 0.0, 1.0) : 0.0;
    return (measure.from + share * way - place).norm();
}

} // namespace

void PatternMeasures::update(const Design& design, const std::set<ElementId>& owners)
{
    for (const ElementId id : owners) {
        m_all.erase(id);
        const Measurement* measured = design.find<Measurement>(id);
        const Patch* from = measured ? design.find<Patch>(measured->from.patch) : nullptr;
        const Patch* to = measured ? design.find<Patch>(measured->to.patch) : nullptr;
        if (from && to && measured->from.position.allFinite() && measured->to.position.allFinite())
            m_all.emplace(id, PatternMeasure{id, measured->from.patch, toLayout(*from, measured->from.position),
                                             toLayout(*to, measured->to.position), from == to});
    }
}

const PatternMeasure* PatternMeasures::at(const Vec2& place, double tolerance) const
{
    const PatternMeasure* best = nullptr;
    double nearest = tolerance;
    for (const auto& [id, measure] : m_all)
        if (const double distance = distanceToLine(measure, place);
            distance < nearest &&
            std::min((measure.from - place).norm(), (measure.to - place).norm()) > tolerance) {
            nearest = distance;
            best = &measure;
        }
    return best;
}

} // namespace bolster
