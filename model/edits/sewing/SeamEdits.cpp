#include "SeamEdits.h"

#include "EditHelpers.h"
#include "SeamStretches.h"

#include <array>

namespace bolster::edits {

namespace {

Edit refused(const Message& why, Message* problem)
{
    if (problem)
        *problem = why;
    return {};
}

std::string seamName(const Design& design, const Seam& seam)
{
    return displayName(design, seam.a.patch) + " \u2013 " + displayName(design, seam.b.patch);
}

Edit withSeams(const Design& design, std::span<const Seam> seams, Message verb)
{
    Edit edit{std::move(verb), {}};
    int next = number(design.nextId());
    for (const Seam& seam : seams)
        edit.changes.push_back({ElementId{next++}, nullptr, makeElement(seam)});
    return edit;
}

/// Changes each seam by change(Seam&); `one` is the verb for a single one, with its name.
template <class Change>
Edit changedSeams(const Design& design, std::span<const ElementId> seams, Change change, const char* one,
                  const char* several)
{
    Edit edit;
    std::string name;
    for (const ElementId id : std::set<ElementId>(seams.begin(), seams.end())) {
        const auto* seam = design.find<Seam>(id);
        if (!seam)
            continue;
        Seam now = *seam;
        change(now);
        if (now == *seam)
            continue;
        name = seamName(design, *seam);
        edit.changes.push_back({id, design.element(id), makeElement(now)});
    }
    if (edit.empty())
        return {};
    edit.verb =
        edit.changes.size() == 1 ? Message{one, {name}} : Message{several, {std::to_string(edit.changes.size())}};
    return edit;
}

} // namespace

Edit addSeam(const Design& design, const Stretch& a, const Stretch& b, bool reversed, Message* problem)
{
    if (const auto why = sewingProblem(design, a, std::array{b}))
        return refused(*why, problem);
    return withSeams(design, std::array{Seam{a, b, reversed}},
                     {QT_TRANSLATE_NOOP("Message", "Sew %1 to %2"),
                      {displayName(design, a.patch), displayName(design, b.patch)}});
}

Edit sewInRow(const Design& design, const Stretch& whole, std::span<const Stretch> row, bool flipped,
              Message* problem)
{
    if (const auto why = sewingProblem(design, whole, row))
        return refused(*why, problem);
    const std::vector<Seam> seams = seamsInRow(design, whole, row, flipped);
    if (seams.size() == 1)
        return addSeam(design, seams[0].a, seams[0].b, seams[0].reversed, problem);
    if (seams.empty())
        return {};
    return withSeams(design, seams,
                     {QT_TRANSLATE_NOOP("Message", "Sew %1 to %2 stretches in a row"),
                      {displayName(design, whole.patch), std::to_string(row.size())}});
}

Edit flipSeams(const Design& design, std::span<const ElementId> seams)
{
    return changedSeams(
        design, seams, [](Seam& seam) { seam.reversed = !seam.reversed; }, QT_TRANSLATE_NOOP("Message", "Flip %1"),
        QT_TRANSLATE_NOOP("Message", "Flip %1 seams"));
}

Edit swapSeamSides(const Design& design, std::span<const ElementId> seams)
{
    return changedSeams(
        design, seams,
        [](Seam& seam) {
            std::swap(seam.a, seam.b);
            seam.ease = -seam.ease;
        },
        QT_TRANSLATE_NOOP("Message", "Swap the sides of %1"),
        QT_TRANSLATE_NOOP("Message", "Swap the sides of %1 seams"));
}

Edit setContinuity(const Design& design, std::span<const ElementId> seams, Continuity continuity)
{
    return changedSeams(
        design, seams, [continuity](Seam& seam) { seam.continuity = continuity; },
        QT_TRANSLATE_NOOP("Message", "Change the continuity of %1"),
        QT_TRANSLATE_NOOP("Message", "Change the continuity of %1 seams"));
}

Edit setMatch(const Design& design, std::span<const ElementId> seams, Match match)
{
    return changedSeams(
        design, seams, [match](Seam& seam) { seam.match = match; },
        QT_TRANSLATE_NOOP("Message", "Change how %1 is matched"),
        QT_TRANSLATE_NOOP("Message", "Change how %1 seams are matched"));
}

Edit dragStretchEnd(const Design& design, ElementId owner, SeamSide side, StretchEnd end, double parameter)
{
    const ElementPtr element = design.element(owner);
    if (!element || !std::isfinite(parameter))
        return {};
    Element moved = *element;
    auto* seam = std::get_if<Seam>(&moved);
    auto* fixation = std::get_if<FixationSeam>(&moved);
    auto* trimmed = std::get_if<OutlineTrim>(&moved);
    if (!seam && !fixation && !trimmed)
        return {};
    Stretch& stretch = fixation              ? fixation->stretch
                       : trimmed             ? trimmed->stretch
                       : side == SeamSide::A ? seam->a
                                             : seam->b;
    const auto* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return {};
    (end == StretchEnd::From ? stretch.from : stretch.to) = parameter;
    stretch = stretchBetween(stretch.patch, patch->outline, stretch.from, stretch.to);
    const std::string name = seam ? seamName(design, *seam) : displayName(design, stretch.patch);
    return replaceElement(design, owner, makeElement(std::move(moved)),
                          {seam       ? QT_TRANSLATE_NOOP("Message", "Move an end of %1")
                           : fixation ? QT_TRANSLATE_NOOP("Message", "Move an end of a fixation of %1")
                                      : QT_TRANSLATE_NOOP("Message", "Move an end of a trim of %1"),
                           {name}});
}

} // namespace bolster::edits
