#include "TwinForm.h"

#include "Document.h"
#include "ElementText.h"
#include "PropertyForm.h"
#include "SelectionEdits.h"
#include "TwinEdits.h"
#include "Twins.h"

#include <array>

namespace bolster {

namespace {

/// What `change` does with the points on the stretches of a seam or fixation.
template <class Change>
void changePointsOn(EditChain& chain, ElementId id, const Change& change)
{
    std::vector<Stretch> stretches;
    if (const Seam* seam = chain.design().find<Seam>(id))
        stretches = {seam->a, seam->b};
    else if (const FixationSeam* fixation = chain.design().find<FixationSeam>(id))
        stretches = {fixation->stretch};
    else if (const OutlineTrim* trimmed = chain.design().find<OutlineTrim>(id))
        stretches = {trimmed->stretch};
    for (const Stretch& stretch : stretches)
        if (const Patch* patch = chain.design().find<Patch>(stretch.patch); patch && !patch->outline.empty())
            chain.add(change(chain.design(), stretch.patch,
                             edits::pointsOnStretch(patch->outline, stretch.from, stretch.to)));
}

Edit releasedSewing(const Design& design, ElementId id)
{
    EditChain chain(design);
    changePointsOn(chain, id, edits::releasePoints);
    return chain.result({QT_TRANSLATE_NOOP("Message", "Release a seam from its mirror image")});
}

Edit relinkedSewing(const Design& design, ElementId id)
{
    EditChain chain(design);
    changePointsOn(chain, id, edits::relinkPoints);
    chain.add(edits::relinkSewing(chain.design(), id));
    return chain.result({QT_TRANSLATE_NOOP("Message", "Re-link a seam to its mirror image")});
}

} // namespace

void TwinForm::addMirroredSewing(PropertyForm& form, ElementId id) const
{
    const Design& design = m_document.design();
    if (!design.find<Seam>(id) && !design.find<FixationSeam>(id) && !design.find<OutlineTrim>(id))
        return;
    const bool released = edits::sewingReleased(design, id);
    if (!released && edits::mirroredElement(design, id) == noElement)
        return;
    form.addInfo(tr("Mirror image"), [this, id] {
        const Design& now = m_document.design();
        const ElementId other = edits::mirroredElement(now, id);
        if (edits::sewingReleased(now, id))
            return tr("released");
        return other == id ? tr("itself") : other == noElement ? QStringLiteral("\u2013") : displayName(now, other);
    });
    if (released)
        form.addButton(tr("Re-lin&k to its mirror image"),
                       [this, id] { m_document.commit(relinkedSewing(m_document.design(), id)); });
    else
        form.addButton(tr("Re&lease from its mirror image"),
                       [this, id] { m_document.commit(releasedSewing(m_document.design(), id)); });
}

void TwinForm::add(PropertyForm& form, ElementId id) const
{
    addMirroredSewing(form, id);
    if (twinOf(m_document.design(), id) == noElement)
        return;
    form.addInfo(tr("Twin of"), [this, id] {
        const ElementId other = twinOf(m_document.design(), id);
        return other == noElement ? QStringLiteral("\u2013") : displayName(m_document.design(), other);
    });
    form.addInfo(tr("Exceptions"), [this, id] {
        const std::size_t count = releasedPoints(m_document.design(), id).size();
        return count == 0 ? tr("none") : tr("%n released points", nullptr, static_cast<int>(count));
    });
    form.addButton(tr("&Unlink from its twin"),
                   [this, id] { m_document.commit(edits::unlinkTwins(m_document.design(), std::array{id})); });
    if (!releasedPoints(m_document.design(), id).empty())
        form.addButton(tr("Re-link all poi&nts"), [this, id] {
            const Design& design = m_document.design();
            m_document.commit(edits::relinkPoints(design, id, releasedPoints(design, id)));
        });
}

} // namespace bolster
