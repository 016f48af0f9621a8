#include "PatchForm.h"

#include "ArcLength.h"
#include "CheckedNumber.h"
#include "CuttingForms.h"
#include "InspectorSubject.h"
#include "PatchShapeEdits.h"
#include "PatchSize.h"
#include "SelectionEdits.h"
#include "Units.h"

namespace bolster {

namespace {

/// Each in the direction in which it has its width or height as it lies.
Edit resized(const Design& design, const std::vector<ElementId>& ids, int axis, double size)
{
    std::vector<ElementId> byAxis[2];
    for (const ElementId id : ids)
        if (const Patch* patch = design.find<Patch>(id))
            byAxis[widthAxis(*patch) == 0 ? axis : 1 - axis].push_back(id);
    EditChain chain(design);
    Message verb;
    for (const int own : {0, 1})
        if (!byAxis[own].empty()) {
            Edit edit = edits::resizePatches(chain.design(), byAxis[own], own, size);
            verb = edit.verb;
            chain.add(edit);
        }
    return chain.result(verb);
}

} // namespace

void PatchForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Patch> patch(m_document, ids, form);
    patch.name();
    patch.reference({}, &Patch::fabric);
    patch.field(&Patch::grain);
    patch.field(&Patch::pressure);
    patch.field(&Patch::wrongSideOut);
    patch.field(&Patch::position);
    patch.field(&Patch::rotation);
    addSize(form, ids);
    patch.info(tr("Outline"), [](const Design&, const Patch& p) {
        return p.outline.empty() ? QString() : lengthText(ArcLength2(p.outline).total(), 0);
    });
    PieceCuttingSection::add(form, patch);
}

void PatchForm::addSize(PropertyForm& form, const Ids& ids) const
{
    form.addNumbers(
        tr("Size"), sizeRange, 2,
        [this, ids](int axis) {
            return sharedNumber(ids.size(), [&](std::size_t i) {
                const Patch* patch = m_document.design().find<Patch>(ids[i]);
                return patch && !patch->outline.empty() ? patchSize(*patch)[axis] : 0.0;
            });
        },
        [this, ids](int axis, double size) {
            commitChecked(m_document, [&](const Design& now) { return resized(now, ids, axis, size); });
        });
    form.explain(
        tr("Width and height as it lies in the pattern view; of a patch that is turned by another angle than "
           "90\u00b0, along its own axes."));
}

} // namespace bolster
