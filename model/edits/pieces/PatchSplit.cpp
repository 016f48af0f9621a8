#include "PatchSplit.h"

#include "ArcLength.h"
#include "ColourwayEdits.h"
#include "DesignCheck.h"
#include "EditBuilder.h"
#include "OutlineCrossings.h"
#include "PatchPoints.h"
#include "PlaneCurves.h"
#include "StretchRemap.h"
#include "Twins.h"

#include <algorithm>

namespace bolster::edits {

namespace {

/// One piece of the patch: its outline begins with a part of the old one, the cut follows.
struct Piece {
    BSpline2 kept;
    BSpline2 outline;
    double cutStart = 0; // parameter
    ElementId id{};

    Piece(const BSpline2& old, double from, double to, std::vector<Vec2> cut)
        : kept(old.part(from, to))
    {
        cut.front() = kept.points().back();
        cut.back() = kept.points().front();
        const double speed = ArcLength2(old).total() / old.period();
        std::vector<double> starts;
        outline = joined({kept, polyline(cut, old.degree(), 0, speed)}, &starts);
        cutStart = starts[1];
    }

    OutlineArc arc() const { return {kept.domainStart(), kept.domainEnd(), id, 0}; }
    Stretch cut() const { return {id, cutStart, outline.domainEnd()}; }
};

class Split {
public:
    Split(const Design& design, ElementId id, const Patch& patch, Piece first, Piece second)
        : m_design(design)
        , m_id(id)
        , m_patch(patch)
        , m_builder(design)
        , m_handles(design)
        , m_large(std::move(first))
        , m_small(std::move(second))
        , m_cut(m_large.outline.part(m_large.cut().from, m_large.cut().to).boundingBox())
    {
        if (std::abs(m_large.outline.signedArea()) < std::abs(m_small.outline.signedArea()))
            std::swap(m_large, m_small);
    }

    Outcome run()
    {
        Patch large = m_patch, small = m_patch;
        large.outline = m_large.outline;
        small.outline = m_small.outline;
        small.name = freeName<Patch>(m_design, m_patch.name);
        m_large.id = m_id;
        m_builder.replace(m_id, std::move(large));
        m_small.id = m_builder.add(std::move(small));

        Outcome outcome;
        remapStretches(m_design, {{m_id, {m_large.arc(), m_small.arc()}}}, {}, m_builder, outcome.dropped);
        m_builder.add(Seam{m_large.cut(), m_small.cut(), true, Match::Length, Continuity::C1});
        for (const auto& [id, element] : m_design.elements())
            if (const PatchCurve* drawn = patchCurve(*element); drawn && drawn->patch == m_id)
                divide(id, *element);
        movePatchPoints(
            m_design.elements(), m_id,
            [&](PatchPoint& point) {
                if (isOfSmall(point.position))
                    point.patch = m_small.id;
            },
            [&](ElementId id, ElementPtr moved) { m_builder.set(id, std::move(moved)); });
        m_design.each<Cushion>([&](ElementId id, Cushion cushion) {
            if (std::ranges::find(cushion.patches, m_id) == cushion.patches.end())
                return;
            cushion.patches.push_back(m_small.id);
            m_builder.replace(id, std::move(cushion));
        });
        m_builder.apply(withColourOf(m_builder.now(), m_id, m_small.id));
        outcome.edit = m_builder.result({QT_TRANSLATE_NOOP("Message", "Split %1"), {displayName(m_design, m_id)}});
        if (!m_shortened.empty())
            outcome.edit.note = {
                QT_TRANSLATE_NOOP("Message",
                                  "Parts of %1 that are shorter than a mesh edge have gone with the cut."),
                {displayName(m_design, m_shortened.front())}};
        return outcome;
    }

private:
    static constexpr int samples = 200;

    /// 1: in the small piece, -1: in the large one, 0: in neither.
    int side(const Vec2& point) const
    {
        if (isInside(m_small.outline, point))
            return 1;
        return isInside(m_large.outline, point) ? -1 : 0;
    }

    /// On an outline a point is inside of neither: it goes with the part of the outline.
    bool isOfSmall(const Vec2& point) const
    {
        const int inside = side(point);
        const bool nearer = m_small.kept.closest(point).distance < m_large.kept.closest(point).distance;
        return inside > 0 || (inside == 0 && nearer);
    }

    void divide(ElementId id, const Element& element)
    {
        const BSpline2& curve = patchCurve(element)->curve;
        std::vector<double> crossings;
        int last = 0, first = 0;
        const bool farFromCut = !m_cut.intersects(curve.boundingBox());
        for (int k = 0; k <= samples; ++k) {
            if (farFromCut && first != 0)
                break; // it is all there
            const double t = curve.domainStart() + curve.period() * k / samples;
            const int now = side(curve.at(t));
            if (now != 0 && last != 0 && now != last)
                crossings.push_back(crossing(curve, t - curve.period() / samples, t, now));
            last = now != 0 ? now : last;
            first = first != 0 ? first : last;
        }
        const auto* handle = std::get_if<HandleCurve>(&element);
        if (crossings.empty())
            moveTo(id, element, first > 0 ? m_small.id : m_id);
        else if (!handle)
            addTo(element, m_small.id);
        else
            divideHandle(id, *handle, crossings, first > 0);
    }

    double crossing(const BSpline2& curve, double low, double high, int after) const
    {
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (side(curve.at(middle)) == after ? high : low) = middle;
        }
        return high;
    }

    void moveTo(ElementId id, const Element& element, ElementId patch)
    {
        if (patch != m_id)
            m_builder.set(id, withPatch(element, patch));
    }

    void addTo(const Element& element, ElementId patch)
    {
        m_builder.set(m_builder.now().nextId(), withPatch(element, patch));
    }

    static ElementPtr withPatch(const Element& element, ElementId patch)
    {
        return std::visit(
            [&](auto value) {
                if constexpr (std::is_base_of_v<PatchCurve, decltype(value)>)
                    value.patch = patch;
                return makeElement(std::move(value));
            },
            element);
    }

    /// All parts keep what they lie on in space. The first one that can be drawn takes the handle's place.
    void divideHandle(ElementId id, const HandleCurve& handle, std::vector<double> cuts, bool inSmall)
    {
        const BSpline2& curve = handle.curve;
        if (curve.closed()) {
            cuts.push_back(cuts.front()); // past the start
            inSmall = !inSmall;
        } else {
            cuts.insert(cuts.begin(), curve.domainStart());
            cuts.push_back(curve.domainEnd());
        }
        const ArcLength2 length(curve);
        std::vector<HandleCurve> parts;
        double longest = 0;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k, inSmall = !inSmall) {
            parts.push_back(partOfHandle(handle, length, cuts[k], cuts[k + 1]));
            parts.back().patch = inSmall ? m_small.id : m_id;
            longest = std::max(longest, ArcLength2(parts.back().curve).total());
        }
        // What is shorter than the mesh edges could not be drawn.
        const double least = std::min(m_design.settings().edgeLength, longest);
        const auto tooShort = [&](const HandleCurve& part) { return ArcLength2(part.curve).total() < least; };
        if (std::erase_if(parts, tooShort) > 0)
            m_shortened.push_back(id);
        for (std::size_t k = 1; k < parts.size(); ++k) {
            parts[k].name = m_handles.free(handle.name);
            m_builder.add(std::move(parts[k]));
        }
        m_builder.replace(id, std::move(parts.front()));
    }

    /// From `from` to `to`, which may lie past the start of a closed one.
    static HandleCurve partOfHandle(const HandleCurve& handle, const ArcLength2& length, double from, double to)
    {
        const BSpline2& curve = handle.curve;
        const auto lengthShare = [&](double t) { return length.at(t) / length.total(); };
        HandleCurve part = handle;
        part.curve = curve.part(from, to);
        const double until = to > from ? lengthShare(to) : lengthShare(to) + 1;
        part.orientation = partOf(handle.orientation, lengthShare(from), until);
        if (handle.hasTarget()) {
            const BSpline3& target = handle.target;
            const ArcLength3 there(target);
            const auto onTarget = [&](double t) {
                return handle.match == Match::Length
                           ? there.parameterAt(lengthShare(t) * there.total())
                           : target.domainStart() + (t - curve.domainStart()) / curve.period() * target.period();
            };
            part.target = target.part(onTarget(from), onTarget(to));
        }
        return part;
    }

    const Design& m_design;
    ElementId m_id;
    const Patch& m_patch;
    EditBuilder m_builder;
    Names<HandleCurve> m_handles;
    std::vector<ElementId> m_shortened; ///< handles
    Piece m_large, m_small;
    BSpline2::Box m_cut; // around the cut
};

Message crossingsProblem(const std::string& name, std::size_t count)
{
    return {QT_TRANSLATE_NOOP("Message", "The line must cross the outline of %1 exactly twice, not %2 times."),
            {name, std::to_string(count)}};
}

Outcome splitOne(const Design& design, ElementId id, const std::vector<Vec2>& line)
{
    const Patch* patch = design.find<Patch>(id);
    if (!patch || line.size() < 2)
        return Outcome::refused({QT_TRANSLATE_NOOP("Message", "Draw a line over a patch to split it."), {}});
    if (outlineProblem(patch->outline))
        return Outcome::refused({QT_TRANSLATE_NOOP("Message", "The outline of %1 is invalid: repair it first."),
                                 {displayName(design, id)}});
    std::vector<Vec2> points;
    for (const Vec2& point : line)
        points.push_back(fromLayout(*patch, point));
    const std::vector<OutlineCrossing> crossings = outlineCrossings(patch->outline, points);
    if (crossings.size() != 2)
        return Outcome::refused(crossingsProblem(displayName(design, id), crossings.size()));

    const std::vector<Vec2> cut = between(points, crossings[0], crossings[1]);
    const std::vector<Vec2> back(cut.rbegin(), cut.rend());
    const Vec2 middle = (cut[0] + cut[1]) / 2;
    if (!isInside(patch->outline, middle) || patch->outline.closest(middle).distance < 0.05)
        return Outcome::refused(
            {QT_TRANSLATE_NOOP("Message", "The line must run inside %1."), {displayName(design, id)}});
    const double t0 = crossings[0].parameter, t1 = crossings[1].parameter;
    Piece first(patch->outline, t0, t1, back), second(patch->outline, t1, t0, cut);
    if (outlineProblem(first.outline) || outlineProblem(second.outline))
        return Outcome::refused(
            {QT_TRANSLATE_NOOP("Message", "A piece of %1 would cross itself or be too narrow: draw another line."),
             {displayName(design, id)}});
    return Split(design, id, *patch, std::move(first), std::move(second)).run();
}

std::vector<Vec2> mirroredLine(const Patch& patch, const Patch& twin, std::vector<Vec2> line)
{
    for (Vec2& point : line)
        point = toLayout(twin, mirroredInOutline(fromLayout(patch, point)));
    return line;
}

/// What the cuts have added to both sides follows each other, too.
Design withLinkedPieces(const Design& start, const Design& half, Design now)
{
    for (const auto& [id, element] : half.elements()) {
        if (start.element(id) || !canBeTwin(*element))
            continue;
        now = now.with({{}, {{id, nullptr, withTwinLink(*element, std::nullopt)}}});
        for (const auto& [other, there] : now.elements()) {
            const bool fits = !half.element(other) && there->index() == element->index() &&
                              unlikePoints(*element, *withTwinLink(*there, std::nullopt), symmetryOf(now)) == 0;
            if (!fits)
                continue;
            now = now.with({{}, {{other, nullptr, withTwinLink(*there, Twin{id, {}})}}});
            break;
        }
    }
    return now;
}

} // namespace

Outcome splitPatch(const Design& design, ElementId id, const std::vector<Vec2>& line)
{
    Outcome outcome = splitOne(design, id, line);
    const auto* twin = design.find<Patch>(twinOf(design, id));
    if (outcome.edit.empty() || !twin)
        return outcome;
    const Design half = design.with(outcome.edit);
    Outcome other = splitOne(half, twinOf(design, id), mirroredLine(*design.find<Patch>(id), *twin, line));
    if (other.edit.empty())
        return other;
    const Design now = withLinkedPieces(design, half, half.with(other.edit));
    Message note = std::move(outcome.edit.note);
    outcome.edit = editBetween(design, now, std::move(outcome.edit.verb));
    outcome.edit.note = std::move(note);
    outcome.dropped.insert(outcome.dropped.end(), other.dropped.begin(), other.dropped.end());
    return outcome;
}

} // namespace bolster::edits
