#include "CopyPaste.h"

#include "DesignJson.h"
#include "EditBuilder.h"
#include "ElementEdits.h"
#include "References.h"

#include <map>

namespace bolster::edits {

namespace {

bool isPiece(const Element& element)
{
    return std::holds_alternative<Patch>(element) || std::holds_alternative<FixationCurve>(element);
}

/// Whether everything that a seam or drawn curve needs is among the ids.
bool belongsTo(const Element& element, const std::set<ElementId>& ids)
{
    const auto isAmong = [&](const Reference& reference) {
        return !isNeeded(reference) || ids.contains(reference.id);
    };
    return liesOnPatch(element) && std::ranges::all_of(references(element), isAmong);
}

/// What the colourway says of these patches.
Colourway partOf(Colourway colourway, const std::set<ElementId>& patches)
{
    std::erase_if(colourway.fabrics, [&](const Colourway::Entry& entry) { return !patches.contains(entry.patch); });
    return colourway;
}

/// The part of a design that `copyText` speaks of.
Design partOf(const Design& design, std::span<const ElementId> ids)
{
    std::set<ElementId> pieces;
    for (const ElementId id : ids)
        if (const ElementPtr element = design.element(id); element && isPiece(*element))
            pieces.insert(id);
    std::set<ElementId> needed = pieces;
    for (const ElementId id : pieces)
        if (const Patch* patch = design.find<Patch>(id); patch && design.find<Fabric>(patch->fabric))
            needed.insert(patch->fabric);
    Edit edit;
    for (const auto& [id, element] : design.elements())
        if (belongsTo(*element, pieces)) {
            edit.changes.push_back({id, nullptr, element});
            if (const SeamTrim* trim = seamTrim(*element); trim && design.find<Fabric>(trim->pipingFabric))
                needed.insert(trim->pipingFabric);
        }
    design.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        Colourway part = partOf(colourway, pieces);
        for (const Colourway::Entry& entry : part.fabrics)
            if (design.find<Fabric>(entry.fabric))
                needed.insert(entry.fabric);
        if (!part.fabrics.empty())
            edit.changes.push_back({id, nullptr, makeElement(std::move(part))});
    });
    for (const ElementId id : needed)
        edit.changes.push_back({id, nullptr, design.element(id)});
    return Design().with(edit);
}

class Adding {
public:
    Adding(const Design& design, const Vec2& offset)
        : m_builder(design)
        , m_offset(offset)
    {}

    Edit all(const Design& source, Message verb)
    {
        source.each<Patch>([&](ElementId id, const Patch& patch) { addPatch(id, source, patch); });
        source.each<FixationCurve>([&](ElementId id, FixationCurve curve) {
            curve.name = freeName<FixationCurve>(m_builder.now(), curve.name);
            m_new[id] = m_builder.add(std::move(curve));
        });
        for (const auto& [old, id] : m_new) {
            followTwin<Patch>(id);
            followTwin<FixationCurve>(id);
        }
        for (const auto& [id, element] : source.elements())
            if (liesOnPatch(*element))
                addDependent(source, *element);
        source.each<Colourway>([&](ElementId, const Colourway& colourway) { addColours(source, colourway); });
        return m_builder.result(std::move(verb));
    }

private:
    void addPatch(ElementId id, const Design& source, Patch patch)
    {
        const Fabric* fabric = source.find<Fabric>(patch.fabric);
        patch.fabric = fabricLike(fabric ? *fabric : Fabric{});
        patch.position += m_offset;
        patch.name = freeName<Patch>(m_builder.now(), patch.name);
        m_new[id] = m_builder.add(std::move(patch));
    }

    ElementId fabricLike(const Fabric& fabric)
    {
        std::optional<ElementId> same;
        m_builder.now().each<Fabric>([&](ElementId id, const Fabric& other) {
            if (!same && other == fabric)
                same = id;
        });
        return same ? *same : m_builder.add(fabric);
    }

    /// Copies of twins are each other's; that of one alone is nobody's.
    template <class T>
    void followTwin(ElementId id)
    {
        const T* copy = m_builder.now().find<T>(id);
        if (!copy || !copy->twin)
            return;
        T changed = *copy;
        if (has(changed.twin->of))
            changed.twin->of = m_new.at(changed.twin->of);
        else
            changed.twin.reset();
        m_builder.replace(id, std::move(changed));
    }

    bool has(ElementId id) const { return m_new.contains(id); }

    /// Under a colourway of the same name, if there is one.
    void addColours(const Design& source, const Colourway& colourway)
    {
        std::optional<ElementId> same;
        m_builder.now().each<Colourway>([&](ElementId id, const Colourway& other) {
            if (!same && other.name == colourway.name)
                same = id;
        });
        if (!same)
            return;
        Colourway wider = *m_builder.now().find<Colourway>(*same);
        for (const Colourway::Entry& entry : colourway.fabrics)
            if (const Fabric* fabric = source.find<Fabric>(entry.fabric); fabric && has(entry.patch))
                wider.fabrics.push_back({m_new.at(entry.patch), fabricLike(*fabric)});
        m_builder.replace(*same, std::move(wider));
    }

    /// Sewn to and drawn in the copies, with fabrics as the design has them.
    void addDependent(const Design& source, const Element& element)
    {
        for (const Reference& reference : references(element))
            if (isNeeded(reference) && !has(reference.id))
                return;
        Element copy = renumbered(element, [&](const Reference& reference) {
            const Fabric* seen = source.find<Fabric>(reference.id);
            return isNeeded(reference) ? m_new.at(reference.id) : seen ? fabricLike(*seen) : ElementId{};
        });
        m_builder.set(m_builder.now().nextId(), withFreeName(m_builder.now(), copy));
    }

    EditBuilder m_builder;
    Vec2 m_offset;
    std::map<ElementId, ElementId> m_new; // of patches and fixation curves: the id in the design
};

Message nameOrCount(const Design& source, const char* one, const char* many)
{
    std::vector<ElementId> pieces;
    for (const auto& [id, element] : source.elements())
        if (isPiece(*element))
            pieces.push_back(id);
    return patchesVerb(source, pieces, one, many);
}

} // namespace

bool canCopy(const Design& design, std::span<const ElementId> ids)
{
    return std::ranges::any_of(ids, [&](ElementId id) {
        const ElementPtr element = design.element(id);
        return element && isPiece(*element);
    });
}

std::string copyText(const Design& design, std::span<const ElementId> ids)
{
    return canCopy(design, ids) ? writeDesign(partOf(design, ids)) : std::string();
}

Outcome paste(const Design& design, std::string_view text, const Vec2& offset)
{
    const ReadDesign read = readDesign(text);
    if (!read.readable)
        return Outcome::refused({QT_TRANSLATE_NOOP("Message", "The clipboard holds no parts of a design."), {}});
    if (!offset.allFinite())
        return {};
    std::vector<ElementId> all;
    for (const auto& [id, element] : read.design.elements())
        all.push_back(id);
    const Design source = partOf(read.design, all);
    Outcome outcome;
    outcome.edit = Adding(design, offset)
                       .all(source, nameOrCount(source, QT_TRANSLATE_NOOP("Message", "Paste %1"),
                                                QT_TRANSLATE_NOOP("Message", "Paste %1 pieces")));
    if (outcome.edit.empty())
        outcome.problem = {QT_TRANSLATE_NOOP("Message", "The clipboard holds no patches and no fixation curves."),
                           {}};
    return outcome;
}

Edit duplicatePatches(const Design& design, std::span<const ElementId> ids, const Vec2& offset)
{
    if (!canCopy(design, ids) || !offset.allFinite())
        return {};
    const Design source = partOf(design, ids);
    return Adding(design, offset)
        .all(source, nameOrCount(source, QT_TRANSLATE_NOOP("Message", "Duplicate %1"),
                                 QT_TRANSLATE_NOOP("Message", "Duplicate %1 pieces")));
}

std::vector<ElementId> addedPieces(const Edit& edit)
{
    std::vector<ElementId> ids;
    for (const Change& change : edit.changes)
        if (!change.before && change.after && isPiece(*change.after))
            ids.push_back(change.id);
    return ids;
}

} // namespace bolster::edits
