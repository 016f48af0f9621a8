#include "TrimRows.h"

#include "ArcLength.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double step = 1; // mm

/// A stretch of an outline by its length.
class TrimRun {
public:
    TrimRun(const Patch& patch, const Stretch& stretch)
        : m_patch(stretch.patch)
        , m_outline(patch.outline)
        , m_arc(m_outline)
        , m_begin(m_arc.at(stretch.from))
        , m_end(m_arc.at(unwrappedEnd(stretch.from, stretch.to, m_outline.domainStart(), m_outline.domainEnd())))
        , m_closed(stretch.from == stretch.to)
        , m_inward(m_outline.signedArea() > 0 ? 1 : -1)
    {}

    double length() const { return m_end - m_begin; }
    int steps() const { return std::max(2, static_cast<int>(std::lround(length() / step))); }

    /// `distance` mm inside the outline, in `count` steps.
    TrimRow row(double distance, int count, bool reversed = false) const
    {
        TrimRow row{m_patch, {}, m_closed};
        std::vector<Vec2> border;
        for (int i = 0; i < count + (m_closed ? 0 : 1); ++i) {
            const double share = static_cast<double>(reversed ? count - i : i) / count;
            const double at = m_begin + share * length();
            border.push_back(m_outline.at(m_outline.wrapped(m_arc.parameterAt(at))));
            const Vec2 along = directionAt(m_closed ? at : std::min(at, m_end - 1e-6 * length()));
            row.points.push_back(border.back() + m_inward * distance * Vec2(-along.y(), along.x()));
        }
        if (distance > 0)
            std::erase_if(row.points, [&](const Vec2& p) { return tooNear(p, border, distance); });
        return row;
    }

private:
    /// At a corner that of what follows, which no longer belongs to the run at its end.
    Vec2 directionAt(double at) const
    {
        return m_outline.derivative(m_outline.wrapped(m_arc.parameterAt(at))).normalized();
    }

    static bool tooNear(const Vec2& p, const std::vector<Vec2>& border, double distance)
    {
        const double least = std::pow(0.97 * distance, 2);
        return std::ranges::any_of(border, [&](const Vec2& b) { return (b - p).squaredNorm() < least; });
    }

    ElementId m_patch;
    BSpline2 m_outline;
    ArcLength2 m_arc;
    double m_begin, m_end;
    bool m_closed;
    double m_inward; // sign
};

TrimRow drawnRow(const PatchCurve& drawn, double across)
{
    const ArcLength2 arc(drawn.curve);
    TrimRow row{drawn.patch, {}, drawn.curve.closed()};
    const int count = std::max(2, static_cast<int>(std::lround(arc.total() / step)));
    for (int i = 0; i < count + (row.closed ? 0 : 1); ++i) {
        const double t = arc.parameterAt(arc.total() * i / count);
        const Vec2 along = drawn.curve.derivative(t).normalized();
        row.points.push_back(drawn.curve.at(t) + across * Vec2(-along.y(), along.x()));
    }
    return row;
}

std::vector<TrimRow> insideRows(const Design& design, const Stretch& stretch, const SeamTrim& trim)
{
    std::vector<TrimRow> rows;
    if (const Patch* patch = design.find<Patch>(stretch.patch)) {
        const TrimRun run(*patch, stretch);
        rows.push_back(run.row(trim.stitchDistance, run.steps()));
        if (trim.stitch == SeamTrim::Stitch::Twin)
            rows.push_back(run.row(2 * trim.stitchDistance, run.steps()));
    }
    return rows;
}

std::vector<TrimRow> borderRow(const Design& design, const Stretch& stretch)
{
    const Patch* patch = design.find<Patch>(stretch.patch);
    if (!patch)
        return {};
    const TrimRun run(*patch, stretch);
    return {run.row(0, run.steps())};
}

} // namespace

std::vector<TrimRow> stitchRows(const Design& design, const Element& element)
{
    const SeamTrim* trim = seamTrim(element);
    if (!trim || trim->stitch == SeamTrim::Stitch::None)
        return {};
    const bool twin = trim->stitch == SeamTrim::Stitch::Twin;
    std::vector<TrimRow> rows;
    if (const auto* seam = std::get_if<Seam>(&element)) {
        for (const Stretch* side : {&seam->a, &seam->b})
            if (const Patch* patch = design.find<Patch>(side->patch); patch && (twin || side == &seam->a)) {
                const TrimRun run(*patch, *side);
                rows.push_back(run.row(trim->stitchDistance, run.steps()));
            }
    } else if (const auto* fixed = std::get_if<FixationSeam>(&element)) {
        rows = insideRows(design, fixed->stretch, *trim);
    } else if (const auto* border = std::get_if<OutlineTrim>(&element)) {
        rows = insideRows(design, border->stretch, *trim);
    } else if (const auto* fancy = std::get_if<FancySeam>(&element)) {
        if (twin)
            rows = {drawnRow(*fancy, trim->stitchDistance), drawnRow(*fancy, -trim->stitchDistance)};
        else
            rows = {drawnRow(*fancy, 0)};
    }
    std::erase_if(rows, [](const TrimRow& row) { return row.points.size() < 2; });
    return rows;
}

std::vector<TrimRow> pipingRows(const Design& design, const Element& element)
{
    const SeamTrim* trim = seamTrim(element);
    if (!trim || !trim->hasPiping())
        return {};
    if (const auto* seam = std::get_if<Seam>(&element)) {
        const Patch* a = design.find<Patch>(seam->a.patch);
        const Patch* b = design.find<Patch>(seam->b.patch);
        if (!a || !b)
            return {};
        const TrimRun first(*a, seam->a), second(*b, seam->b);
        return {first.row(0, first.steps()), second.row(0, first.steps(), seam->reversed)};
    }
    if (const auto* fixed = std::get_if<FixationSeam>(&element))
        return borderRow(design, fixed->stretch);
    if (const auto* border = std::get_if<OutlineTrim>(&element))
        return borderRow(design, border->stretch);
    if (const auto* fancy = std::get_if<FancySeam>(&element))
        return {drawnRow(*fancy, 0)};
    return {};
}

} // namespace bolster
