// The mirrored copies of patches and curves, with what belongs to them.
#include "TwinEdits.h"

#include "ColourwayEdits.h"
#include "EditBuilder.h"
#include "EditHelpers.h"
#include "PatchMark.h"
#include "SewnMirror.h"
#include "Twins.h"

namespace bolster::edits {

namespace {

constexpr double layoutGap = 40; // mm, between the pattern and a copy that lies beside it

Box2 layoutBox(const Patch& patch)
{
    Box2 box;
    for (const Vec2& point : patch.outline.points())
        box.extend(toLayout(patch, point));
    return box;
}

/// Lies where the axis shows the other one.
void placeInMirror(Patch& patch, const Symmetry& symmetry)
{
    patch.position = symmetry.mirroredInLayout(patch.position);
    patch.rotation = std::remainder(2 * symmetry.axisAngle() - 180 - patch.rotation, 360);
}

/// Whether the middle of one lies on the other.
bool overlap(const BSpline2& outline, const Stretch& a, const Stretch& b)
{
    const auto length = [&](const Stretch& s) {
        return unwrappedEnd(s.from, s.to, outline.domainStart(), outline.domainEnd()) - s.from;
    };
    const auto onto = [&](const Stretch& s, const Stretch& other) {
        const double ahead = s.from + length(s) / 2 - other.from;
        return ahead - outline.period() * std::floor(ahead / outline.period()) < length(other);
    };
    return a.patch == b.patch && (onto(a, b) || onto(b, a));
}

/// Nothing is sewn to it and nothing fixes it.
bool isFree(const Design& design, const Stretch& stretch)
{
    const BSpline2& outline = design.find<Patch>(stretch.patch)->outline;
    bool free = true;
    const auto look = [&](const Stretch& other) { free = free && !overlap(outline, stretch, other); };
    design.each<Seam>([&](ElementId, const Seam& seam) {
        look(seam.a);
        look(seam.b);
    });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& fixation) { look(fixation.stretch); });
    return free;
}

class TwinMaker {
public:
    TwinMaker(const Design& design, const MirroredName& mirroredName)
        : m_start(design)
        , m_now(design)
        , m_mirroredName(mirroredName)
    {
        Settings settings = design.settings();
        if (!settings.symmetry)
            settings.symmetry = Symmetry();
        m_symmetry = *settings.symmetry;
        put(settingsId, makeElement(settings));
    }

    void add(ElementId id)
    {
        const ElementPtr element = m_now.element(id);
        if (!element || !canBeTwin(*element) || twinOf(m_now, id) != noElement)
            return;
        if (const auto* patch = std::get_if<Patch>(element.get()))
            addPatch(id, *patch);
        else if (const auto* curve = std::get_if<FixationCurve>(element.get()))
            addCurve(id, *curve);
        else
            addDrawn(id, patchCurve(*element)->patch);
    }

    /// Seams last: they need both patches.
    Edit result(Message verb)
    {
        if (m_made.empty())
            return {};
        for (const auto& [id, twin] : m_made)
            if (m_start.find<Patch>(id))
                addSewn(id);
        return editBetween(m_start, m_now, std::move(verb));
    }

private:
    void put(ElementId id, ElementPtr element) { m_now = m_now.with({{}, {{id, nullptr, std::move(element)}}}); }

    ElementId put(ElementPtr element)
    {
        const ElementId id = m_now.nextId();
        put(id, std::move(element));
        return id;
    }

    template <class T>
    ElementId putTwin(ElementId of, T copy)
    {
        copy.name = freeName<T>(m_now, m_mirroredName(copy.name));
        copy.twin = Twin{of, {}};
        return m_made[of] = put(makeElement(std::move(copy)));
    }

    void addPatch(ElementId id, Patch copy)
    {
        const auto outline = mirroredCurve(copy.outline);
        if (!outline)
            return;
        copy.outline = *outline;
        copy.grain = mirroredGrain(copy.grain);
        placeInMirror(copy, m_symmetry);
        moveAside(copy);
        const ElementId twin = putTwin(id, std::move(copy));
        for (const auto& [other, element] : m_start.elements())
            if (const PatchCurve* drawn = patchCurve(*element); drawn && drawn->patch == id)
                addDrawn(other, id);
        m_start.each<Cushion>([&](ElementId cushion, const Cushion&) {
            Cushion wider = *m_now.find<Cushion>(cushion);
            if (std::find(wider.patches.begin(), wider.patches.end(), id) == wider.patches.end())
                return;
            wider.patches.push_back(twin);
            put(cushion, makeElement(std::move(wider)));
        });
        m_now = m_now.with(withColourOf(m_now, id, twin));
    }

    /// Out of the way of the patches that are there.
    void moveAside(Patch& copy) const
    {
        const Box2 own = layoutBox(copy);
        Box2 all;
        bool taken = false;
        m_now.each<Patch>([&](ElementId, const Patch& patch) {
            const Box2 box = layoutBox(patch);
            all.extend(box);
            const Box2 common = own.intersection(box);
            taken = taken || (!common.isEmpty() && common.sizes().minCoeff() > 1e-6);
        });
        if (taken)
            copy.position.x() += all.max().x() + layoutGap - own.min().x();
    }

    ElementId addCurve(ElementId id, FixationCurve copy)
    {
        const auto curve = mirroredCurve(copy.curve, m_symmetry);
        if (!curve)
            return noElement;
        copy.curve = *curve;
        return putTwin(id, std::move(copy));
    }

    /// In the twin of its patch, or in the patch itself.
    void addDrawn(ElementId id, ElementId patch)
    {
        if (m_made.contains(id) || twinOf(m_now, id) != noElement)
            return;
        const ElementId twin = twinOf(m_now, patch);
        const ElementId on = twin == noElement ? patch : twin;
        const ElementPtr copy = mirroredDrawn(*m_start.element(id), on, m_symmetry);
        if (!copy)
            return;
        std::visit(
            [&]<class T>(const T& drawn) {
                if constexpr (std::is_base_of_v<PatchCurve, T>)
                    putTwin(id, drawn);
            },
            *copy);
    }

    void addSewn(ElementId patch)
    {
        m_start.each<Seam>([&](ElementId id, const Seam& seam) {
            if ((seam.a.patch == patch || seam.b.patch == patch) && m_sewn.insert(id).second)
                addSeam(seam);
        });
        m_start.each<FixationSeam>([&](ElementId, const FixationSeam& seam) {
            if (seam.stretch.patch == patch)
                addFixation(seam);
        });
        eachMarkKind([&]<class T>() {
            m_start.each<T>([&](ElementId, const T& mark) {
                if (whereOf(mark).patch != patch)
                    return;
                if (const auto image = SewnMirror(m_now, twinPairs(m_now)).of(mark))
                    put(makeElement(*image));
            });
        });
    }

    void addSeam(const Seam& original)
    {
        const SewnMirror mirror(m_now, twinPairs(m_now));
        const auto seam = mirror.of(original);
        if (!seam || mirror.counterpart(original).id != noElement)
            return;
        for (const Stretch& side : {seam->a, seam->b})
            if (mirror.twin(side.patch) == noElement && !isFree(m_now, side))
                return;
        put(makeElement(*seam));
    }

    void addFixation(const FixationSeam& original)
    {
        auto fixation = SewnMirror(m_now, twinPairs(m_now)).of(original);
        if (!fixation) { // its curve has no mirror image yet
            const auto* curve = m_now.find<FixationCurve>(original.curve);
            if (!curve || addCurve(original.curve, *curve) == noElement)
                return;
            fixation = SewnMirror(m_now, twinPairs(m_now)).of(original);
        }
        if (fixation)
            put(makeElement(*fixation));
    }

    Design m_start;
    Design m_now;
    const MirroredName& m_mirroredName;
    Symmetry m_symmetry;
    std::map<ElementId, ElementId> m_made; // twins by original
    std::set<ElementId> m_sewn;            // seams that have been dealt with
};

} // namespace

Edit makeTwins(const Design& design, std::span<const ElementId> ids, const MirroredName& mirroredName)
{
    TwinMaker maker(design, mirroredName);
    for (const ElementId id : ids)
        maker.add(id);
    if (ids.size() == 1)
        return maker.result(
            {QT_TRANSLATE_NOOP("Message", "Make a mirror twin of %1"), {displayName(design, ids.front())}});
    return maker.result({QT_TRANSLATE_NOOP("Message", "Make %1 mirror twins"), {std::to_string(ids.size())}});
}

} // namespace bolster::edits
