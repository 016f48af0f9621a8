#include "PatchBorder.h"

#include "ArcLength.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

PatchBorder::PatchBorder(const BSpline2& outline, double step)
    : m_outline(&outline)
{
    const ArcLength2 length(outline);
    const std::vector<double> breaks = outline.breaks();
    for (std::size_t piece = 0; piece + 1 < breaks.size(); ++piece) {
        const double t0 = breaks[piece], t1 = breaks[piece + 1];
        const int count = std::max(1, static_cast<int>(std::ceil(length.between(t0, t1) / step)));
        for (int k = 0; k < count; ++k) {
            m_parameters.push_back(t0 + (t1 - t0) * k / count);
            m_points.push_back(outline.at(m_parameters.back()));
        }
    }
    m_parameters.push_back(outline.domainEnd());
}

Box2 PatchBorder::box() const
{
    Box2 box;
    for (const Vec2& p : m_points)
        box.extend(p);
    return box;
}

bool PatchBorder::contains(const Vec2& p) const
{
    bool inside = false;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const Vec2 &a = m_points[i], &b = m_points[(i + 1) % m_points.size()];
        if ((a.y() <= p.y()) != (b.y() <= p.y()) &&
            p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

std::optional<PatchBorder::Meeting> PatchBorder::firstMeeting(const Vec2& a, const Vec2& b) const
{
    std::optional<Meeting> first;
    const Vec2 u = b - a;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const Vec2 v = m_points[(i + 1) % m_points.size()] - m_points[i], w = m_points[i] - a;
        const double denominator = cross(u, v);
        if (denominator == 0)
            continue;
        const double fraction = cross(w, v) / denominator, place = cross(w, u) / denominator;
        if (fraction >= 0 && fraction <= 1 && place >= 0 && place <= 1 && (!first || fraction < first->fraction))
            first = {fraction, m_parameters[i] + place * (m_parameters[i + 1] - m_parameters[i])};
    }
    return first;
}

} // namespace bolster
