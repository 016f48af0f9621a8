// What is drawn in a twin, or taken out of it, means the same for the other one.
#include "EditBuilder.h"
#include "SeamsOfTwins.h"
#include "SewnMirror.h"
#include "Twins.h"

namespace bolster::edits {

namespace {

class DrawnFollower {
public:
    DrawnFollower(const Design& before, const Design& now)
        : m_before(before)
        , m_now(now)
        , m_mirror(now, heldPairs(now, before))
        , m_builder(now)
    {}

    Design result()
    {
        for (const ElementId id : differences(m_before, m_now)) {
            removeDrawn(id);
            addDrawn(id);
        }
        return m_builder.now();
    }

private:
    bool isNew(ElementId id) const { return !m_before.element(id) && m_now.element(id); }
    bool isGone(ElementId id) const { return m_before.element(id) && !m_now.element(id); }

    /// The patch where the mirror shows what is drawn, if both are still there.
    ElementId drawnOn(const Element& drawn) const
    {
        const PatchCurve* curve = patchCurve(drawn);
        return curve ? m_mirror.twin(curve->patch) : noElement;
    }

    void removeDrawn(ElementId id)
    {
        if (!isGone(id) || drawnOn(*m_before.element(id)) == noElement)
            return;
        const ElementId other = twinOf(m_before, id);
        if (other != noElement && m_now.element(other))
            m_builder.remove(other);
    }

    void addDrawn(ElementId id)
    {
        const ElementPtr drawn = isNew(id) ? m_builder.now().element(id) : nullptr;
        const ElementId patch = drawn ? drawnOn(*drawn) : noElement;
        if (patch == noElement || twinLink(*drawn) || twinOf(m_builder.now(), id) != noElement)
            return;
        const ElementPtr copy = mirroredDrawn(*drawn, patch, symmetryOf(m_now));
        if (!copy)
            return;
        const ElementId there = drawnAlike(*drawn, patch);
        if (there != noElement)
            m_builder.set(there, withTwinLink(*m_now.element(there), Twin{id, {}}));
        else
            m_builder.set(m_builder.now().nextId(), withTwinLink(*withFreeName(*copy), Twin{id, {}}));
    }

    ElementPtr withFreeName(const Element& drawn) const
    {
        return std::visit(
            [&]<class T>(T value) {
                if constexpr (std::is_base_of_v<PatchCurve, T>)
                    value.name = freeName<T>(m_builder.now(), value.name);
                return makeElement(std::move(value));
            },
            drawn);
    }

    /// One that came in the same edit.
    ElementId drawnAlike(const Element& drawn, ElementId patch) const
    {
        for (const auto& [id, element] : m_now.elements())
            if (isNew(id) && element->index() == drawn.index() && patchCurve(*element)->patch == patch &&
                twinOf(m_now, id) == noElement && unlikePoints(drawn, *element, symmetryOf(m_now)) == 0)
                return id;
        return noElement;
    }

    const Design& m_before;
    const Design& m_now;
    SewnMirror m_mirror;
    EditBuilder m_builder;
};

} // namespace

Design withTwinDrawings(const Design& before, const Design& now)
{
    return DrawnFollower(before, now).result();
}

} // namespace bolster::edits
