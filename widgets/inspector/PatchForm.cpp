#include "PatchForm.h"

#include "ArcLength.h"
#include "CheckedNumber.h"
#include "CuttingForms.h"
#include "InspectorSubject.h"
#include "LayoutEdits.h"
#include "PatchShapeEdits.h"
#include "Units.h"

namespace bolster {

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
                return patch && !patch->outline.empty() ? edits::layoutBox(*patch).sizes()[axis] : 0.0;
            });
        },
        [this, ids](int axis, double size) {
            commitChecked(m_document,
                          [&](const Design& now) { return edits::resizePatches(now, ids, axis, size); });
        });
    form.explain(tr("Width and height as it lies in the pattern view."));
}

} // namespace bolster
