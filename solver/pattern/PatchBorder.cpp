#include "PatchBorder.h"

#include "ArcLength.h"

#include <algorithm>
#include <cmath>

namespace bolster {

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
    sortIntoRows(step);
}

void PatchBorder::sortIntoRows(double step)
{
    const Box2 around = box();
    const double height = around.sizes().y();
    const double wanted = std::clamp(height / step, 1.0, static_cast<double>(m_points.size()));
    m_low = around.min().y();
    m_rowHeight = height / std::floor(wanted);
    m_rows.resize(static_cast<std::size_t>(wanted));
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const auto [low, high] = std::minmax(m_points[i].y(), m_points[(i + 1) % m_points.size()].y());
        for (std::size_t row = rowAt(low); row <= rowAt(high); ++row)
            m_rows[row].push_back(static_cast<int>(i));
    }
}

/// Of heights beyond the polygon the nearest one.
std::size_t PatchBorder::rowAt(double y) const
{
    const double row = (y - m_low) / m_rowHeight;
    return row > 0 ? std::min(static_cast<std::size_t>(std::min(row, 1e9)), m_rows.size() - 1) : 0;
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
    for (const int i : m_rows[rowAt(p.y())]) {
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
    const auto [low, high] = std::minmax(a.y(), b.y());
    const double slack = 1e-6 * m_rowHeight; // for rounding
    std::vector<int> near;
    for (std::size_t row = rowAt(low - slack); row <= rowAt(high + slack); ++row)
        near.insert(near.end(), m_rows[row].begin(), m_rows[row].end());
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const int i : near) {
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
