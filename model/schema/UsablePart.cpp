// What remains of a design without its bad elements.
#include "DesignCheck.h"
#include "References.h"
#include "UsualFields.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

/// An element of the right kind.
bool isThere(const Design& design, const Reference& reference)
{
    const ElementPtr element = design.element(reference.id);
    return element && element->index() == reference.kind;
}

// The first element that this one needs and the design does not have.
std::optional<ElementId> missingReference(const Design& design, const Element& element)
{
    for (const Reference& reference : references(element))
        if (isNeeded(reference) && !isThere(design, reference))
            return reference.id;
    return std::nullopt;
}

/// Without entries that name nothing, or a patch for the second time.
Colourway usableEntries(const Design& design, Colourway colourway)
{
    std::set<ElementId> known;
    std::erase_if(colourway.fabrics, [&](const Colourway::Entry& entry) {
        return !design.find<Patch>(entry.patch) || !design.find<Fabric>(entry.fabric) ||
               !known.insert(entry.patch).second;
    });
    return colourway;
}

/// In its stages each sees what the ones before have left.
class UsablePart {
public:
    UsablePart(const Design& design, const Problems& problems)
        : m_design(design)
        , m_usable(design)
    {
        for (const Problem& problem : problems)
            if (problem.severity == Severity::Error)
                m_wrongFields[problem.element].push_back(problem.field);
    }

    Design take()
    {
        mendOrLeaveOut();
        while (leaveOutWhatMissesSomething()) // a patch without its fabric takes its seams with it
            ;
        thinColourways();
        mendEdgeLength();
        return m_usable;
    }

    /// What has become of whom, by element.
    Problems reported()
    {
        std::ranges::stable_sort(m_reported, {}, &Problem::element);
        return std::move(m_reported);
    }

private:
    void report(ElementId id, std::string field, Message what)
    {
        m_reported.push_back(
            {id, elementLabel(id, *m_design.element(id)), std::move(field), std::move(what), Severity::Warning});
    }

    void mendOrLeaveOut()
    {
        Edit edit;
        for (const auto& [id, element] : m_design.elements()) {
            const auto wrong = m_wrongFields.find(id);
            if (std::holds_alternative<Colourway>(*element))
                continue; // its usable part follows from what it names
            if (std::holds_alternative<Quarantined>(*element))
                edit.changes.push_back({id, element, nullptr});
            else if (wrong != m_wrongFields.end())
                edit.changes.push_back({id, element, mended(id, *element, wrong->second)});
            else
                continue;
            if (!edit.changes.back().after)
                report(id, "", {QT_TRANSLATE_NOOP("Message", "left out because of its errors")});
        }
        m_usable = m_usable.with(edit);
    }

    /// What is wrong with looks, or cutting, must not cost the shape. Null when there is more.
    ElementPtr mended(ElementId id, const Element& element, const std::vector<std::string>& wrong)
    {
        if (ElementPtr mended = withUsualFields(element, wrong)) {
            for (const std::string& field : wrong)
                report(id, field, {QT_TRANSLATE_NOOP("Message", "the usual value is used instead")});
            return mended;
        }
        if (!std::holds_alternative<Fabric>(element))
            return nullptr;
        // Without it all its patches would be lost for one wrong number.
        report(id, "", {QT_TRANSLATE_NOOP("Message", "the usual values of a fabric are used instead")});
        return makeElement(Fabric{});
    }

    bool leaveOutWhatMissesSomething()
    {
        Edit edit;
        for (const auto& [id, element] : m_usable.elements()) {
            const std::optional<ElementId> missing = missingReference(m_usable, *element);
            if (!missing)
                continue;
            const ElementPtr needed = m_design.element(*missing);
            report(id, "",
                   {QT_TRANSLATE_NOOP("Message", "left out because it needs %1, which is not there"),
                    {needed ? elementLabel(*missing, *needed) : elementLabel("", *missing, "")}});
            edit.changes.push_back({id, element, nullptr});
        }
        m_usable = m_usable.with(edit);
        return !edit.changes.empty();
    }

    void thinColourways()
    {
        Edit edit;
        m_usable.each<Colourway>([&](ElementId id, const Colourway& colourway) {
            Colourway rest = usableEntries(m_usable, colourway);
            if (rest == colourway)
                return;
            report(id, "",
                   {QT_TRANSLATE_NOOP("Message", "what it says of missing patches and fabrics is left out")});
            edit.changes.push_back({id, m_usable.element(id), makeElement(std::move(rest))});
        });
        m_usable = m_usable.with(edit);
    }

    /// Twelve millimetres, unless that makes too many triangles of the patches that are left.
    void mendEdgeLength()
    {
        const auto wrong = m_wrongFields.find(settingsId);
        if (wrong == m_wrongFields.end() || std::ranges::count(wrong->second, "edge_length") == 0)
            return;
        Settings settings;
        settings.edgeLength = std::max(settings.edgeLength, std::ceil(smallestEdgeLength(m_usable)));
        m_usable = m_usable.with({{}, {{settingsId, nullptr, makeElement(settings)}}});
        m_reported.push_back({settingsId,
                              "settings",
                              "edge_length",
                              {QT_TRANSLATE_NOOP("Message", "an edge length of %1 mm is used instead"),
                               {numberText(settings.edgeLength)}},
                              Severity::Warning});
    }

    const Design& m_design;
    Design m_usable;
    std::map<ElementId, std::vector<std::string>> m_wrongFields;
    Problems m_reported;
};

} // namespace

Design usablePart(const Design& design, const Problems& problems, Problems* leftOut)
{
    UsablePart part(design, problems);
    Design usable = part.take();
    if (leftOut)
        *leftOut = part.reported();
    return usable;
}

} // namespace bolster
