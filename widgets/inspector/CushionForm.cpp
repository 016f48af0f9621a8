#include "CushionForm.h"

#include "InspectorSubject.h"

namespace bolster {

namespace {

/// Verbs that are in the histories of projects, though no edit is called so any more.
[[maybe_unused]] constexpr const char* earlierVerbs[] = {QT_TRANSLATE_NOOP("Message", "Change the distance of %1"),
                                                         QT_TRANSLATE_NOOP("Message", "Change the voxels of %1")};

} // namespace

/// Everything, or the cover that one patch is sewn to.
void CushionForm::addCoverChoice(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Cushion> cushion(m_document, ids, form);
    auto [patches, names] = elementsToChoose(m_document.design(), placeOfKind<Patch>());
    for (QString& name : names)
        name = tr("Cover of %1").arg(name);
    names.prepend(tr("Every cover"));
    form.addChoice(
        tr("Pushes"), names,
        [cushion, patches = patches] {
            const auto shared = cushion.shared([](const Cushion& c) { return c.patches; });
            const std::vector<ElementId> chosen = shared.value_or(patches);
            return !shared || chosen.size() > 1 ? -1 : chosen.empty() ? 0 : placeOf(patches, chosen.front()) + 1;
        },
        [cushion, patches = patches](int chosen) {
            cushion.change(QT_TRANSLATE_NOOP("Message", "Change what %1 pushes"), [&](Cushion& c) {
                c.patches.clear();
                if (chosen > 0)
                    c.patches.push_back(patches[static_cast<std::size_t>(chosen - 1)]);
            });
        });
}

void CushionForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Cushion> cushion(m_document, ids, form);
    cushion.name();
    cushion.field(&Cushion::enabled);
    cushion.reference({}, &Cushion::frame);
    m_parts.addPadded(form, ids);
    addCoverChoice(form, ids);
    form.explain(cushion.fieldAt(&Cushion::patches).tip());
    cushion.field(&Cushion::dilation);
    cushion.field(&Cushion::strength);
    cushion.field(&Cushion::distance);
    cushion.field(&Cushion::voxel);
    if (!cushion.several())
        m_parts.addVoxelNote(form, ids.front());
}

std::vector<int> CushionForm::rowsDependOn(const Ids& ids) const
{
    std::vector<int> frames;
    for (const ElementId id : ids)
        if (const Cushion* cushion = m_document.design().find<Cushion>(id))
            frames.push_back(number(cushion->frame));
    return frames;
}

} // namespace bolster
