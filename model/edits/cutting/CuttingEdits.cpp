#include "CuttingEdits.h"

#include "CornerWay.h"
#include "EditBuilder.h"
#include "ElementRules.h"
#include "OutlineCrossings.h"
#include "PatchMark.h"

namespace bolster::edits {

namespace {

constexpr double nearest = 0.1; // mm: marks of one kind that are nearer are the same

void say(Message* problem, Message why)
{
    if (problem)
        *problem = std::move(why);
}

const Patch* usable(const Design& design, ElementId id, Message* problem)
{
    const Patch* patch = design.find<Patch>(id);
    if (patch && !patch->outline.empty())
        return patch;
    say(problem, {QT_TRANSLATE_NOOP("Message", "There is no such place on an outline."), {}});
    return nullptr;
}

bool samePlace(const BSpline2& outline, double a, double b)
{
    return (outline.at(outline.wrapped(a)) - outline.at(outline.wrapped(b))).norm() < nearest;
}

std::optional<Message> problemOf(const Design& design, ElementId id, const EdgeAllowance& mark)
{
    const Patch* patch = design.find<Patch>(mark.stretch.patch);
    if (!patch || patch->outline.empty())
        return std::nullopt;
    std::optional<Message> problem;
    design.each<EdgeAllowance>([&](ElementId other, const EdgeAllowance& there) {
        if (!problem && other != id && there.stretch.patch == mark.stretch.patch &&
            stretchesOverlap(patch->outline, there.stretch, mark.stretch))
            problem =
                Message{QT_TRANSLATE_NOOP("Message", "A part of this stretch of %1 has a seam allowance of its own "
                                                     "already: change that one, or choose another stretch."),
                        {displayName(design, mark.stretch.patch)}};
    });
    return problem;
}

/// Notches and joins of corners.
template <class T>
std::optional<Message> problemAt(const Design& design, ElementId id, const T& mark)
{
    const Patch* patch = design.find<Patch>(mark.place.patch);
    bool taken = false;
    design.each<T>([&](ElementId other, const T& there) {
        taken =
            taken || (other != id && patch && !patch->outline.empty() && there.place.patch == mark.place.patch &&
                      samePlace(patch->outline, there.place.at, mark.place.at));
    });
    if (!taken)
        return std::nullopt;
    if constexpr (std::is_same_v<T, Notch>)
        return Message{QT_TRANSLATE_NOOP("Message", "There is a notch of %1 at this place already."),
                       {displayName(design, mark.place.patch)}};
    else
        return Message{QT_TRANSLATE_NOOP("Message", "This corner of %1 has a join of its own already."),
                       {displayName(design, mark.place.patch)}};
}

} // namespace

Edit setAllowance(const Design& design, std::span<const ElementId> patches,
                  const std::optional<CutAllowance>& allowance)
{
    EditBuilder builder(design);
    for (const ElementId id : patches)
        if (const Patch* patch = design.find<Patch>(id)) {
            Patch changed = *patch;
            changed.allowance = allowance;
            builder.replace(id, std::move(changed));
        }
    return builder.result(patchesVerb(design, patches,
                                      QT_TRANSLATE_NOOP("Message", "Change the seam allowance of %1"),
                                      QT_TRANSLATE_NOOP("Message", "Change the seam allowance of %1 patches")));
}

Edit setEdgeAllowance(const Design& design, const Stretch& stretch, double width, Message* problem)
{
    if (!usable(design, stretch.patch, problem))
        return {};
    const Message verb{QT_TRANSLATE_NOOP("Message", "Change the seam allowance of an edge of %1"),
                       {displayName(design, stretch.patch)}};
    const EdgeAllowance wanted{stretch, width};
    ElementId there = noElement;
    design.each<EdgeAllowance>([&](ElementId id, const EdgeAllowance& other) {
        if (other.stretch == stretch)
            there = id;
    });
    if (there != noElement)
        return replaceWith(design, there, wanted, verb);
    if (auto why = problemOf(design, noElement, wanted)) {
        say(problem, std::move(*why));
        return {};
    }
    Edit edit = addElement(design, makeElement(wanted));
    edit.verb = verb;
    return edit;
}

Edit setCutCorner(const Design& design, const OutlinePlace& place, CornerJoin join, Message* problem)
{
    const Patch* patch = usable(design, place.patch, problem);
    if (!patch)
        return {};
    const Message verb{QT_TRANSLATE_NOOP("Message", "Change a corner of the cut line of %1"),
                       {displayName(design, place.patch)}};
    ElementId there = noElement;
    design.each<CutCorner>([&](ElementId id, const CutCorner& other) {
        if (other.place.patch == place.patch && samePlace(patch->outline, other.place.at, place.at))
            there = id;
    });
    if (there != noElement)
        return replaceWith(design, there, CutCorner{design.find<CutCorner>(there)->place, join}, verb);
    Edit edit = addElement(design, makeElement(CutCorner{place, join}));
    edit.verb = verb;
    return edit;
}

Edit addNotch(const Design& design, const OutlinePlace& place, const NotchShape& shape, Message* problem)
{
    if (!usable(design, place.patch, problem))
        return {};
    const Notch notch{place, shape};
    if (auto why = problemAt(design, noElement, notch)) {
        say(problem, std::move(*why));
        return {};
    }
    Edit edit = addElement(design, makeElement(notch));
    edit.verb = {QT_TRANSLATE_NOOP("Message", "Add a notch to %1"), {displayName(design, place.patch)}};
    return edit;
}

Edit movePlace(const Design& design, ElementId mark, double at)
{
    const Message verb{QT_TRANSLATE_NOOP("Message", "Move a notch"), {}};
    if (const Notch* notch = design.find<Notch>(mark)) {
        Notch moved = *notch;
        moved.place.at = at;
        return replaceWith(design, mark, moved, verb);
    }
    if (const CutCorner* corner = design.find<CutCorner>(mark)) {
        CutCorner moved = *corner;
        moved.place.at = at;
        return replaceWith(design, mark, moved, {QT_TRANSLATE_NOOP("Message", "Move the join of a corner"), {}});
    }
    return {};
}

Edit setCornerDistance(const Design& design, std::span<const ElementId> notches, double length, Message* problem)
{
    EditBuilder builder(design);
    for (const ElementId id : notches) {
        const Notch* notch = design.find<Notch>(id);
        const Patch* patch = notch ? usable(design, notch->place.patch, problem) : nullptr;
        if (!patch)
            return {};
        std::optional<CornerWay> way = wayFromCorner(patch->outline, notch->place.at);
        if (way)
            way->length = length;
        const std::optional<double> at = way ? endOfWay(patch->outline, *way) : std::nullopt;
        if (!at) {
            say(problem, {QT_TRANSLATE_NOOP("Message", "This edge of %1 is not as long as that."),
                          {displayName(design, notch->place.patch)}});
            return {};
        }
        Notch moved = *notch;
        moved.place.at = *at;
        builder.replace(id, moved);
    }
    return builder.result({QT_TRANSLATE_NOOP("Message", "Move a notch"), {}});
}

Edit addDrillHole(const Design& design, const PatchPoint& point, const std::string& name, Message* problem)
{
    const Patch* patch = usable(design, point.patch, problem);
    if (!patch)
        return {};
    if (!isInside(patch->outline, point.position)) {
        say(problem, {QT_TRANSLATE_NOOP("Message", "A drill hole must lie inside its patch."), {}});
        return {};
    }
    DrillHole hole;
    hole.name = freeName<DrillHole>(design, name);
    hole.place = point;
    return addElement(design, makeElement(std::move(hole)));
}

Edit moveDrillHoles(const Design& design, std::span<const ElementId> holes, const Vec2& delta)
{
    EditBuilder builder(design);
    for (const ElementId id : holes)
        if (const DrillHole* hole = design.find<DrillHole>(id)) {
            DrillHole moved = *hole;
            moved.place.position += delta;
            builder.replace(id, std::move(moved));
        }
    return builder.result(patchesVerb(design, holes, QT_TRANSLATE_NOOP("Message", "Move %1"),
                                      QT_TRANSLATE_NOOP("Message", "Move %1 drill holes")));
}

Edit addInternalLine(const Design& design, ElementId patch, BSpline2 curve, InternalLine::Purpose purpose,
                     const std::string& name)
{
    InternalLine line;
    line.name = freeName<InternalLine>(design, name);
    line.patch = patch;
    line.curve = std::move(curve);
    line.purpose = purpose;
    return addElement(design, makeElement(std::move(line)));
}

Edit setLabel(const Design& design, ElementId patch, const std::optional<PieceLabelPlace>& label)
{
    const Patch* found = design.find<Patch>(patch);
    if (!found)
        return {};
    Patch changed = *found;
    changed.cutting.label = label;
    return replaceWith(design, patch, std::move(changed),
                       {QT_TRANSLATE_NOOP("Message", "Move the label of %1"), {displayName(design, patch)}});
}

std::optional<Message> markProblem(const Design& design, ElementId id, const Element& mark)
{
    if (const auto* allowance = std::get_if<EdgeAllowance>(&mark))
        return problemOf(design, id, *allowance);
    if (const auto* notch = std::get_if<Notch>(&mark))
        return problemAt(design, id, *notch);
    if (const auto* corner = std::get_if<CutCorner>(&mark))
        return problemAt(design, id, *corner);
    return std::nullopt;
}

} // namespace bolster::edits
