// What an edit of seams, fixations and trims means on the other side of the mirror.
#include "SewingLead.h"

#include "CuttingEdits.h"
#include "EditBuilder.h"
#include "ElementRules.h"
#include "ElementStretches.h"
#include "PatchMark.h"
#include "SeamStretches.h"
#include "SeamsOfTwins.h"
#include "TrimEdits.h"
#include "TwinEdits.h"
#include "Twins.h"

#include <algorithm>
#include <array>

namespace bolster::edits {

namespace {

/// Whether something else of its kind lies on the stretches.
bool isTaken(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    if (const auto* seam = std::get_if<Seam>(element.get())) {
        const Design without = design.with({{}, {{id, element, nullptr}}});
        return sewingProblem(without, seam->a, std::array{seam->b}).has_value();
    }
    if (const auto* trimmed = std::get_if<OutlineTrim>(element.get()))
        return trimProblem(design, trimmed->stretch, id).has_value();
    if (!std::holds_alternative<FixationSeam>(*element))
        return markProblem(design, id, *element).has_value();
    const auto& fixation = std::get<FixationSeam>(*element);
    const BSpline2& outline = design.find<Patch>(fixation.stretch.patch)->outline;
    bool taken = false;
    design.each<FixationSeam>([&](ElementId other, const FixationSeam& seam) {
        taken = taken || (other != id && seam.hasCurve() == fixation.hasCurve() &&
                          seam.stretch.patch == fixation.stretch.patch &&
                          stretchesOverlap(outline, seam.stretch, fixation.stretch));
    });
    return taken;
}

/// Pieces that lie across the axis are middle pieces; what is elsewhere may just not have its twin yet.
bool liesAcrossAxis(const Patch& patch, const Symmetry& symmetry)
{
    Box2 own, mirrored;
    for (const Vec2& point : patch.outline.points()) {
        own.extend(toLayout(patch, point));
        mirrored.extend(symmetry.mirroredInLayout(toLayout(patch, point)));
    }
    return !own.intersection(mirrored).isEmpty();
}

/// A stretch on a patch without a twin that nothing holds.
bool isFreeInTheMiddle(const Design& design, const Stretch& stretch)
{
    const Patch& patch = *design.find<Patch>(stretch.patch);
    bool free = liesAcrossAxis(patch, symmetryOf(design));
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) {
        free = free &&
               (seam.stretch.patch != stretch.patch || !stretchesOverlap(patch.outline, seam.stretch, stretch));
    });
    return free;
}

class SewingFollower {
public:
    SewingFollower(const Design& before, const Design& now)
        : m_before(before)
        , m_now(now)
        , m_old(m_before, heldPairs(before, now))
        , m_new(m_now, heldPairs(now, before))
        , m_builder(now)
    {}

    Design result()
    {
        const std::set<ElementId> touched = differences(m_before, m_now);
        findUnmirrored(touched);
        for (const ElementId id : touched) {
            removeLike<Seam>(id);
            removeLike<FixationSeam>(id);
            eachMarkKind([&]<class T>() { removeLike<T>(id); });
        }
        for (const ElementId id : touched) {
            change<Seam>(id);
            change<FixationSeam>(id);
            eachMarkKind([&]<class T>() { change<T>(id); });
        }
        takeBackWhatIsInTheWay();
        for (const ElementId id : touched) {
            addLike<Seam>(id);
            addLike<FixationSeam>(id);
            eachMarkKind([&]<class T>() { addLike<T>(id); });
        }
        return m_builder.now();
    }

private:
    bool isNew(ElementId id) const { return !m_before.element(id) && m_now.element(id); }
    bool isGone(ElementId id) const { return m_before.element(id) && !m_now.element(id); }

    /// Pieces of a patch that has been divided are nobody's image.
    bool onOldPatches(const Element& sewn) const
    {
        const std::vector<Stretch> stretches = stretchesOf(sewn);
        return std::ranges::all_of(stretches,
                                   [&](const Stretch& s) { return m_before.element(s.patch) != nullptr; });
    }

    template <class T>
    bool hasImage(const T& value) const
    {
        return onOldPatches(*makeElement(value)) && m_new.of(value).has_value();
    }

    /// New seams without an image: what they take the place of stays on the other side.
    void findUnmirrored(const std::set<ElementId>& touched)
    {
        for (const ElementId id : touched) {
            const auto* seam = isNew(id) ? m_now.find<Seam>(id) : nullptr;
            const auto* fixation = isNew(id) ? m_now.find<FixationSeam>(id) : nullptr;
            if ((seam && !hasImage(*seam)) || (fixation && !hasImage(*fixation) && !hasNewCurve(*fixation)))
                for (const Stretch& stretch : stretchesOf(*m_now.element(id)))
                    m_unmirrored.push_back(stretch);
        }
    }

    bool isReplaced(const Element& sewn) const
    {
        for (const Stretch& stretch : stretchesOf(sewn))
            for (const Stretch& other : m_unmirrored)
                if (const auto* patch = m_before.find<Patch>(stretch.patch);
                    patch && stretch.patch == other.patch && stretchesOverlap(patch->outline, stretch, other))
                    return true;
        return false;
    }

    template <class T>
    void removeLike(ElementId id)
    {
        const T* gone = isGone(id) ? m_before.find<T>(id) : nullptr;
        if (!gone || isReplaced(*m_before.element(id)) || m_old.released(*m_before.element(id)))
            return;
        if constexpr (std::is_same_v<T, FixationSeam>)
            if (gone->hasCurve() && !m_now.element(gone->curve)) // the removal of a curve unlinks, no more
                return;
        // What the edit has made of the other one itself stays: two that were merged there may be one in its place.
        const ElementId other = m_old.counterpart(*gone).id;
        if (other != noElement && m_now.element(other) && m_now.element(other) == m_before.element(other))
            m_builder.remove(other);
    }

    template <class T>
    void change(ElementId id)
    {
        const T* before = m_before.find<T>(id);
        const T* now = m_now.find<T>(id);
        if (!before || !now || m_old.released(*m_before.element(id)) || !onOldPatches(*m_now.element(id)))
            return;
        const auto [other, swapped] = m_old.counterpart(*before);
        const T* there = m_builder.now().template find<T>(other);
        if (other == noElement || !there)
            return;
        const Lead<T> lead{*before, *now};
        if (other == id) {
            changeOwnMirror(id, lead);
            return;
        }
        const bool bothChanged = m_before.element(other) != m_now.element(other);
        if (bothChanged && (other < id || alike(lead, swapped, m_new, *there)))
            return;
        if (const auto result = followed(lead, swapped, m_new, *there); result && !(*result == *there)) {
            m_builder.replace(other, *result);
            m_changed.push_back(other);
        }
    }

    /// A seam between a patch and its twin that lies across the plane: its sides stay alike.
    void changeOwnMirror(ElementId id, const Lead<Seam>& lead)
    {
        const bool first = !(lead.before.a == lead.now.a);
        if (first == !(lead.before.b == lead.now.b))
            return;
        Seam seam = lead.now;
        if (const auto image = m_new.of(first ? seam.a : seam.b)) {
            (first ? seam.b : seam.a) = image->stretch;
            m_builder.replace(id, seam);
        }
    }
    void changeOwnMirror(ElementId, const Lead<FixationSeam>&) {}
    template <PatchMark T>
    void changeOwnMirror(ElementId, const Lead<T>&)
    {}

    void takeBackWhatIsInTheWay()
    {
        const Design all = m_builder.now();
        for (const ElementId id : m_changed)
            if (isTaken(all, id))
                m_builder.set(id, m_now.element(id));
    }

    bool hasNewCurve(const FixationSeam& fixation) const { return fixation.hasCurve() && isNew(fixation.curve); }

    std::optional<Seam> imageOf(const Seam& seam) { return m_new.of(seam); }
    template <PatchMark T>
    std::optional<T> imageOf(const T& mark)
    {
        return m_new.of(mark);
    }
    /// Also of one with a curve that is new: this one gets a twin.
    std::optional<FixationSeam> imageOf(const FixationSeam& fixation)
    {
        auto image = m_new.of(fixation);
        if (image || !hasNewCurve(fixation))
            return image;
        FixationSeam bare = fixation;
        bare.curve = {};
        image = m_new.of(bare);
        FixationCurve curve = *m_now.find<FixationCurve>(fixation.curve);
        const auto mirrored = mirroredCurve(curve.curve, symmetryOf(m_now));
        if (!image || !mirrored || curve.twin)
            return std::nullopt;
        curve.curve = *mirrored;
        curve.name = freeName<FixationCurve>(m_builder.now(), curve.name);
        curve.twin = Twin{fixation.curve, {}};
        image->curve = m_builder.add(std::move(curve));
        return image;
    }

    template <class T>
    void addLike(ElementId id)
    {
        const T* added = isNew(id) ? m_now.find<T>(id) : nullptr;
        if (!added || !onOldPatches(*m_now.element(id)) || m_new.released(*m_now.element(id)) ||
            m_new.counterpart(*added).id != noElement)
            return;
        const Design before = m_builder.now();
        const auto image = imageOf(*added);
        if (!image)
            return;
        for (const Stretch& stretch : stretchesOf(*makeElement(*image)))
            if (m_new.twin(stretch.patch) == noElement && !isFreeInTheMiddle(before, stretch))
                return;
        const ElementId made = m_builder.add(*image);
        if (isTaken(m_builder.now(), made))
            m_builder = EditBuilder(before);
    }

    const Design& m_before;
    const Design& m_now;
    SewnMirror m_old, m_new;
    EditBuilder m_builder;
    std::vector<Stretch> m_unmirrored;
    std::vector<ElementId> m_changed;
};

} // namespace

Design withTwinSewing(const Design& before, const Design& now)
{
    return SewingFollower(before, now).result();
}

} // namespace bolster::edits
