#include "CuttingForms.h"

#include "CheckedNumber.h"
#include "CornerWay.h"
#include "CuttingEdits.h"
#include "Icons.h"
#include "StretchLength.h"
#include "Units.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// An allowance that may be there or not: a mark, and its fields while it is there. `at` finds it in an element,
/// `otherwise` says what counts without it, and what it begins with.
template <class T, class At, class Otherwise>
void addAllowance(PropertyForm& form, const InspectorSubject<T>& subject, const QString& own, At at,
                  Otherwise otherwise)
{
    const CutAllowance usual;
    const DescribedField width = describedField(usual, &usual.width), corner = describedField(usual, &usual.corner);
    const char* const verb = width.field.verb;
    form.addCheck(
        own, [subject, at] { return subject.shared([&](const T& t) { return at(t).has_value(); }); },
        [subject, at, otherwise, verb](bool on) {
            subject.change(verb, [&](T& t) { at(t) = on ? std::optional(otherwise()) : std::nullopt; });
        });
    form.addNumber(
        width.label(), width.range(),
        [subject, at, otherwise] {
            return subject.shared([&](const T& t) { return at(t).value_or(otherwise()).width; });
        },
        [subject, at, otherwise, verb](double value) {
            subject.change(verb, [&](T& t) {
                if (!at(t))
                    at(t) = otherwise();
                at(t)->width = value;
            });
        });
    form.addChoice(
        corner.label(), corner.choices(),
        [subject, at, otherwise] {
            const auto shared = subject.shared([&](const T& t) { return at(t).value_or(otherwise()).corner; });
            return shared ? static_cast<int>(*shared) : -1;
        },
        [subject, at, otherwise, verb](int chosen) {
            subject.change(verb, [&](T& t) {
                if (!at(t))
                    at(t) = otherwise();
                at(t)->corner = static_cast<CornerJoin>(chosen);
            });
        });
}

QString placeText(const Design& design, ElementId patch)
{
    return displayName(design, patch);
}

} // namespace

void PieceCuttingSection::add(PropertyForm& form, const InspectorSubject<Patch>& patch)
{
    form.addHeading(tr("Cutting"), icon(QStringLiteral("notch")));
    addAllowance(
        form, patch, tr("Own seam allowance"), [](auto& p) -> auto& { return p.allowance; },
        [patch] { return patch.design().settings().cutting.allowance.value_or(CutAllowance()); });
    patch.field(&Patch::cutting, &PieceCutting::quantity);
    patch.field(&Patch::cutting, &PieceCutting::pair);
    patch.field(&Patch::cutting, &PieceCutting::nap);
    patch.field(&Patch::cutting, &PieceCutting::tolerance);
    patch.textRow(
        patch.fieldAt(&Patch::cutting, &PieceCutting::note), [](auto& p) -> auto& { return p.cutting.note; });
    form.addCheck(
        tr("Label where it finds room"),
        [patch] { return patch.shared([](const Patch& p) { return !p.cutting.label; }); },
        [patch](bool found) {
            patch.change(Description<PieceLabelPlace>::verb, [&](Patch& p) {
                if (found || p.outline.empty())
                    p.cutting.label.reset();
                else // where it is dragged from
                    p.cutting.label = PieceLabelPlace{p.outline.boundingBox().center(), p.grain - 90};
            });
        });
}

void DesignCuttingSection::add(PropertyForm& form, const InspectorSubject<Settings>& settings)
{
    form.addHeading(tr("Cutting"), icon(QStringLiteral("notch")));
    addAllowance(
        form, settings, tr("Seam allowance of all patches"), [](auto& s) -> auto& { return s.cutting.allowance; },
        [] { return CutAllowance(); });
    const auto notches = &Settings::cutting;
    settings.field(notches, &DesignCutting::notches, &AutomaticNotches::shape, &NotchShape::kind);
    settings.labelledField(tr("Depth of notches"), notches, &DesignCutting::notches, &AutomaticNotches::shape,
                           &NotchShape::depth);
    settings.labelledField(tr("Width of notches"), notches, &DesignCutting::notches, &AutomaticNotches::shape,
                           &NotchShape::width);
    settings.field(notches, &DesignCutting::notches, &AutomaticNotches::spacing);
    settings.field(notches, &DesignCutting::notches, &AutomaticNotches::ends);
    settings.field(notches, &DesignCutting::notches, &AutomaticNotches::telling);
    settings.textRow(
        settings.fieldAt(notches, &DesignCutting::style), [](auto& s) -> auto& { return s.cutting.style; });
    settings.textRow(
        settings.fieldAt(notches, &DesignCutting::version), [](auto& s) -> auto& { return s.cutting.version; });
}

void EdgeAllowanceForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<EdgeAllowance> edge(m_document, ids, form);
    edge.info(tr("Outline"), [](const Design& design, const EdgeAllowance& e) {
        return tr("%1, %2").arg(placeText(design, e.stretch.patch), lengthText(stretchLength(design, e.stretch)));
    });
    edge.field(&EdgeAllowance::width);
}

void CutCornerForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<CutCorner> corner(m_document, ids, form);
    corner.info(tr("Patch"),
                [](const Design& design, const CutCorner& c) { return placeText(design, c.place.patch); });
    corner.field(&CutCorner::join);
}

void NotchForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Notch> notch(m_document, ids, form);
    notch.info(tr("Patch"), [](const Design& design, const Notch& n) { return placeText(design, n.place.patch); });
    addDistance(form, ids);
    notch.field(&Notch::shape, &NotchShape::kind);
    notch.field(&Notch::shape, &NotchShape::depth);
    notch.field(&Notch::shape, &NotchShape::width);
    notch.field(&Notch::twice);
}

void NotchForm::addDistance(PropertyForm& form, const Ids& ids) const
{
    const auto distance = [this](ElementId id) -> std::optional<double> {
        const Notch* notch = m_document.design().find<Notch>(id);
        const Patch* patch = notch ? m_document.design().find<Patch>(notch->place.patch) : nullptr;
        const auto way =
            patch && !patch->outline.empty() ? wayFromCorner(patch->outline, notch->place.at) : std::nullopt;
        return way ? std::optional(std::round(100 * way->length) / 100) : std::nullopt;
    };
    if (!std::ranges::all_of(ids, [&](ElementId id) { return distance(id).has_value(); }))
        return; // round pieces have no corners
    form.addNumber(
        tr("From the corner"), {millimetreSuffix, 2, 0, 1e6},
        [distance, ids] {
            return sharedNumber(ids.size(), [&](std::size_t i) { return distance(ids[i]).value_or(0); });
        },
        [this, ids, &form](double length) {
            Message problem;
            commitChecked(m_document,
                          [&](const Design& now) { return edits::setCornerDistance(now, ids, length, &problem); });
            if (problem.empty())
                return;
            emit m_document.refused(problem);
            form.refresh();
        });
    form.explain(tr("Along the outline from the nearer corner, on the same side of it."));
}

void DrillHoleForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<DrillHole> hole(m_document, ids, form);
    hole.name();
    hole.info(tr("Patch"),
              [](const Design& design, const DrillHole& h) { return placeText(design, h.place.patch); });
    hole.field(&DrillHole::place, &PatchPoint::position);
    hole.field(&DrillHole::diameter);
}

} // namespace bolster
