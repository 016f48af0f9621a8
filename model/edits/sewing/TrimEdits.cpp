#include "TrimEdits.h"

#include "EditBuilder.h"
#include "ElementRules.h"
#include "SeamStretches.h"

namespace bolster::edits {

namespace {

Message trimVerb(const Design& design, const Edit& edit)
{
    if (edit.changes.size() != 1)
        return {QT_TRANSLATE_NOOP("Message", "Change the trim of %1 seams"), {std::to_string(edit.changes.size())}};
    const ElementPtr& element = edit.changes.front().before;
    std::string name = displayName(design, edit.changes.front().id);
    if (const auto* seam = std::get_if<Seam>(element.get()))
        name = displayName(design, seam->a.patch) + " \u2013 " + displayName(design, seam->b.patch);
    else if (const auto* fixation = std::get_if<FixationSeam>(element.get()))
        name = displayName(design, fixation->stretch.patch);
    else if (const auto* trimmed = std::get_if<OutlineTrim>(element.get()))
        name = displayName(design, trimmed->stretch.patch);
    return {QT_TRANSLATE_NOOP("Message", "Change the trim of %1"), {name}};
}

} // namespace

Edit setTrim(const Design& design, std::span<const ElementId> elements, const SeamTrim& trim)
{
    Edit edit;
    for (const ElementId id : std::set<ElementId>(elements.begin(), elements.end())) {
        const ElementPtr element = design.element(id);
        const SeamTrim* before = element ? seamTrim(*element) : nullptr;
        if (before && !(*before == trim))
            edit.changes.push_back({id, element, withTrim(*element, trim)});
    }
    if (!edit.empty())
        edit.verb = trimVerb(design, edit);
    return edit;
}

std::optional<Message> trimProblem(const Design& design, const Stretch& stretch, ElementId except)
{
    const auto* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty() || !std::isfinite(stretch.from) || !std::isfinite(stretch.to))
        return Message{QT_TRANSLATE_NOOP("Message", "There is no such stretch of an outline."), {}};
    std::optional<Message> problem = stretchProblem(design, stretch, noElement); // has no length, or is sewn
    design.each<OutlineTrim>([&](ElementId id, const OutlineTrim& other) {
        if (!problem && id != except && other.stretch.patch == stretch.patch &&
            stretchesOverlap(patch->outline, other.stretch, stretch))
            problem =
                Message{QT_TRANSLATE_NOOP("Message", "A part of this stretch of %1 has a trim already: change "
                                                     "that one, or choose another stretch."),
                        {displayName(design, stretch.patch)}};
    });
    return problem;
}

Edit addOutlineTrim(const Design& design, const Stretch& stretch, const SeamTrim& trim, Message* problem)
{
    if (const auto why = trimProblem(design, stretch)) {
        if (problem)
            *problem = *why;
        return {};
    }
    Edit edit = addElement(design, makeElement(OutlineTrim{stretch, trim}));
    edit.verb = {QT_TRANSLATE_NOOP("Message", "Trim the edge of %1"), {displayName(design, stretch.patch)}};
    return edit;
}

} // namespace bolster::edits
