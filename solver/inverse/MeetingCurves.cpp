#include "MeetingCurves.h"

#include <vector>

namespace bolster {

namespace {

constexpr double meeting = 0.01; // mm

/// Of an open curve.
struct CurveEnd {
    ElementId curve{};
    std::size_t point = 0;
    Vec3 before = Vec3::Zero(), after = Vec3::Zero();
};

std::vector<CurveEnd> endsOf(const Design& before, const Design& after)
{
    std::vector<CurveEnd> ends;
    before.each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        const auto* now = after.find<FixationCurve>(id);
        const std::vector<Vec3>& points = curve.curve.points();
        if (!now || curve.curve.closed() || points.empty() || now->curve.points().size() != points.size())
            return;
        for (const std::size_t k : {std::size_t{0}, points.size() - 1})
            ends.push_back({id, k, points[k], now->curve.points()[k]});
    });
    return ends;
}

Vec3 meanOf(const std::vector<Vec3>& places)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places)
        sum += place;
    return sum / static_cast<double>(places.size());
}

/// Where curves that pass through a point, and do not end there, have taken it.
std::vector<Vec3> takenAlong(const Design& before, const Design& after, const Vec3& point)
{
    std::vector<Vec3> places;
    before.each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        const BSpline3& line = curve.curve;
        const auto* now = after.find<FixationCurve>(id);
        if (!now || line.empty() || line.boundingBox().exteriorDistance(point) > meeting)
            return;
        const auto isEnd = [&](const Vec3& end) { return !line.closed() && (end - point).norm() <= meeting; };
        if (isEnd(line.points().front()) || isEnd(line.points().back()))
            return;
        if (const BSpline3::Closest closest = line.closest(point); closest.distance <= meeting)
            places.push_back(now->curve.at(closest.parameter));
    });
    return places;
}

} // namespace

Design withMeetingCurves(const Design& before, const Design& after)
{
    const std::vector<CurveEnd> ends = endsOf(before, after);
    Design joined = after;
    for (const CurveEnd& end : ends) {
        std::vector<Vec3> places = takenAlong(before, after, end.before);
        if (places.empty())
            for (const CurveEnd& other : ends)
                if ((other.before - end.before).norm() <= meeting)
                    places.push_back(other.after);
        const Vec3 place = meanOf(places);
        if ((place - end.after).norm() <= 1e-9)
            continue;
        FixationCurve curve = *joined.find<FixationCurve>(end.curve);
        curve.curve = curve.curve.withPoint(static_cast<int>(end.point), place);
        joined = joined.with({{}, {{end.curve, joined.element(end.curve), makeElement(std::move(curve))}}});
    }
    return joined;
}

} // namespace bolster
