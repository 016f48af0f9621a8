#include "EditCheck.h"

#include "BezierPieces.h"
#include "DesignCheck.h"
#include "EditHelpers.h"
#include "ElementRules.h"
#include "ElementStretches.h"

#include <algorithm>

namespace bolster::edits {

namespace {

constexpr double shortestPiece = 1e-3; // mm, as in the rules for designs
constexpr double reachShare = 0.25;    // of the edge length: ends of handles this near to the outline lie on it
constexpr int chords = 8;              // of a curved span

/// A curve as straight pieces; of a closed one the first point is repeated.
struct Polyline {
    std::vector<Vec2> points;
    Box2 box;

    explicit Polyline(const BSpline2& curve)
    {
        for (const BezierPiece<2>& piece : bezierPieces(curve)) {
            const int count = piece.degree == 1 ? 1 : chords;
            for (int k = points.empty() ? 0 : 1; k <= count; ++k)
                points.push_back(piece.at(static_cast<double>(k) / count));
        }
        for (const Vec2& point : points)
            box.extend(point);
    }

    /// `along` is the number of the piece and the share of it.
    Vec2 at(double along) const
    {
        const auto k = std::min(static_cast<std::size_t>(along), points.size() - 2);
        return points[k] + (along - static_cast<double>(k)) * (points[k + 1] - points[k]);
    }

    /// Inside, when it is closed.
    bool contains(const Vec2& p) const
    {
        bool inside = false;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const Vec2 &a = points[k], &b = points[k + 1];
            if ((a.y() > p.y()) != (b.y() > p.y()) &&
                p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                inside = !inside;
        }
        return inside;
    }

    /// Where it crosses another one, along this one; in no order.
    std::vector<double> crossings(const Polyline& other) const
    {
        std::vector<double> found;
        for (std::size_t j = 0; j + 1 < other.points.size(); ++j) {
            const Vec2 &c = other.points[j], &d = other.points[j + 1];
            if (!box.intersects(Box2(c.cwiseMin(d), c.cwiseMax(d))))
                continue;
            for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                const Vec2 u = points[k + 1] - points[k], v = d - c, w = c - points[k];
                const double cross = u.x() * v.y() - u.y() * v.x();
                const double s = (w.x() * v.y() - w.y() * v.x()) / cross;
                const double t = (w.x() * u.y() - w.y() * u.x()) / cross;
                if (cross != 0 && s >= 0 && s <= 1 && t >= 0 && t <= 1)
                    found.push_back(static_cast<double>(k) + s);
            }
        }
        return found;
    }
};

/// How many parts of a line lie inside an outline, and how many outside.
struct Parts {
    int inside = 0;
    int outside = 0;
};

/// Crossings within `reach` of an end of the line do not count.
Parts partsOf(const Polyline& outline, const Polyline& line, double reach)
{
    const auto atEnd = [&](const Vec2& p) {
        return (p - line.points.front()).norm() <= reach || (p - line.points.back()).norm() <= reach;
    };
    std::vector<double> cuts = line.crossings(outline);
    std::erase_if(cuts, [&](double along) { return atEnd(line.at(along)); });
    cuts.push_back(0);
    cuts.push_back(static_cast<double>(line.points.size() - 1));
    std::ranges::sort(cuts);
    Parts parts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        if (cuts[i + 1] - cuts[i] > 1e-9)
            ++(outline.contains(line.at(0.5 * (cuts[i] + cuts[i + 1]))) ? parts.inside : parts.outside);
    return parts;
}

/// A fancy seam may end beyond the outline, where it is cut off; a handle curve ends inside, or on the outline.
bool leavesPatch(const Design& design, const Element& element)
{
    const PatchCurve& drawn = *patchCurve(element);
    const auto* patch = design.find<Patch>(drawn.patch);
    if (!patch || drawn.curve.empty() || patch->outline.empty())
        return false;
    const Polyline outline(patch->outline), line(drawn.curve);
    if (!outline.box.intersects(line.box))
        return true;
    const bool cutOff = std::holds_alternative<FancySeam>(element) && !drawn.curve.closed();
    const double reach = drawn.curve.closed() ? 0 : cutOff ? 0.05 : reachShare * design.settings().edgeLength;
    const Parts parts = partsOf(outline, line, reach);
    return parts.inside != 1 || (!cutOff && parts.outside > 0);
}

/// Whether no points of the stretch are apart: cheaper than its length.
bool vanishes(const Design& design, const Stretch& stretch)
{
    const auto* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return false;
    const BSpline2& outline = patch->outline;
    const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    const Vec2 start = outline.at(outline.wrapped(stretch.from));
    for (int k = 1; k <= chords; ++k) {
        const double t = stretch.from + (end - stretch.from) * k / chords;
        if ((outline.at(outline.wrapped(t)) - start).norm() >= shortestPiece)
            return false;
    }
    return true;
}

/// The element of the same sort that uses a part of the stretch, or noElement.
ElementId otherOn(const Design& design, ElementId id, const Element& element, const Stretch& stretch)
{
    const auto* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return noElement;
    const auto* fixation = std::get_if<FixationSeam>(&element);
    for (const auto& [otherId, other] : design.elements()) {
        if (otherId == id || other->index() != element.index())
            continue;
        if (fixation && fixation->hasCurve() != std::get<FixationSeam>(*other).hasCurve())
            continue; // a direction may be held where a curve is
        for (const Stretch& taken : stretchesOf(*other))
            if (taken.patch == stretch.patch && stretchesOverlap(patch->outline, taken, stretch))
                return otherId;
    }
    return noElement;
}

std::optional<Message> outlineBreaks(const Design& design, ElementId id, const Patch& patch)
{
    if (!outlineProblem(patch.outline))
        return std::nullopt;
    const bool crosses = !patch.outline.empty() && patch.outline.closed() && selfIntersection(patch.outline);
    return crosses ? Message{QT_TRANSLATE_NOOP("Message", "The outline of %1 would cross or touch itself."),
                             {displayName(design, id)}}
                   : Message{QT_TRANSLATE_NOOP("Message", "The outline of %1 would enclose nothing."),
                             {displayName(design, id)}};
}

std::optional<Message> curveBreaks(const Design& design, ElementId id, const Element& element)
{
    if (!leavesPatch(design, element))
        return std::nullopt;
    return Message{QT_TRANSLATE_NOOP("Message", "%1 would not lie inside %2 any more."),
                   {displayName(design, id), displayName(design, patchCurve(element)->patch)}};
}

std::optional<Message> lengthBreaks(const Design& design, const Element& element)
{
    for (const Stretch& stretch : stretchesOf(element))
        if (vanishes(design, stretch))
            return Message{QT_TRANSLATE_NOOP("Message", "A stretch of %1 that is sewn, fixed or trimmed would "
                                                        "have no length."),
                           {displayName(design, stretch.patch)}};
    return std::nullopt;
}

std::optional<Message> overlapBreaks(const Design& design, ElementId id, const Element& element)
{
    const std::vector<Stretch> stretches = stretchesOf(element);
    for (const Stretch& stretch : stretches)
        if (const ElementId other = otherOn(design, id, element, stretch); other != noElement) {
            if (const auto* fixation = design.find<FixationSeam>(other))
                return Message{QT_TRANSLATE_NOOP("Message", "The stretch would overlap another one of %1 that is "
                                                            "fixed to %2."),
                               {displayName(design, stretch.patch), displayName(design, fixation->curve)}};
            if (design.find<OutlineTrim>(other))
                return Message{QT_TRANSLATE_NOOP("Message",
                                                 "The stretch would overlap another one of %1 that has a "
                                                 "trim."),
                               {displayName(design, stretch.patch)}};
            if (design.find<EdgeAllowance>(other))
                return Message{QT_TRANSLATE_NOOP("Message", "The stretch would overlap another one of %1 that has "
                                                            "its own seam allowance."),
                               {displayName(design, stretch.patch)}};
            const auto& seam = *design.find<Seam>(other);
            return Message{QT_TRANSLATE_NOOP("Message", "The stretch would overlap the seam of %1 and %2."),
                           {displayName(design, seam.a.patch), displayName(design, seam.b.patch)}};
        }
    const auto* patch = stretches.size() == 2 ? design.find<Patch>(stretches[0].patch) : nullptr;
    if (patch && !patch->outline.empty() && stretches[0].patch == stretches[1].patch &&
        stretchesOverlap(patch->outline, stretches[0], stretches[1]))
        return Message{QT_TRANSLATE_NOOP("Message", "The two sides of the seam would overlap."), {}};
    return std::nullopt;
}

class Check {
public:
    Check(const Design& before, const Edit& edit)
        : m_before(before)
        , m_after(before.with(edit))
    {
        for (const Change& change : edit.changes)
            if (change.after)
                look(change.id, *change.after);
        lookAtWhatLiesOnOutlines();
    }

    std::optional<Breakage> result() const
    {
        return m_found.elements.empty() ? std::nullopt : std::optional(m_found);
    }

private:
    template <class Rule>
    void rule(ElementId id, const Rule& breaks)
    {
        std::optional<Message> why = breaks(m_after);
        const ElementPtr old = m_before.element(id);
        if (!why || (old && old->index() == m_after.element(id)->index() && breaks(m_before)))
            return;
        if (m_found.elements.empty())
            m_found.why = std::move(*why);
        m_found.elements.insert(id);
    }

    void look(ElementId id, const Element& element)
    {
        if (const auto* patch = std::get_if<Patch>(&element)) {
            const auto* old = m_before.find<Patch>(id);
            if (old && old->outline == patch->outline)
                return;
            m_outlines.insert(id);
            rule(id, [id](const Design& design) { return outlineBreaks(design, id, *design.find<Patch>(id)); });
        } else if (patchCurve(element)) {
            lookAtCurve(id);
        } else if (!stretchesOf(element).empty()) {
            lookAtLength(id);
            rule(id, [id](const Design& design) { return overlapBreaks(design, id, *design.element(id)); });
        }
    }

    void lookAtCurve(ElementId id)
    {
        rule(id, [id](const Design& design) { return curveBreaks(design, id, *design.element(id)); });
    }

    void lookAtLength(ElementId id)
    {
        rule(id, [id](const Design& design) { return lengthBreaks(design, *design.element(id)); });
    }

    void lookAtWhatLiesOnOutlines()
    {
        if (m_outlines.empty())
            return;
        for (const auto& [id, element] : m_after.elements()) {
            const PatchCurve* drawn = patchCurve(*element);
            // In an outline that crosses itself there is no inside to leave.
            if (drawn && m_outlines.contains(drawn->patch) && !m_found.elements.contains(drawn->patch))
                lookAtCurve(id);
            for (const Stretch& stretch : stretchesOf(*element))
                if (m_outlines.contains(stretch.patch)) {
                    lookAtLength(id);
                    break;
                }
        }
    }

    const Design& m_before;
    Design m_after;
    std::set<ElementId> m_outlines; // patches whose outlines are changed
    Breakage m_found;
};

} // namespace

std::optional<Breakage> brokenBy(const Design& before, const Edit& edit)
{
    return edit.empty() ? std::nullopt : Check(before, edit).result();
}

} // namespace bolster::edits
