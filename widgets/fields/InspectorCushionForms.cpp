// The inspector's forms for cushions and foam.
#include "InspectorForms.h"
#include "InspectorSubject.h"
#include "PlacementFields.h"

#include <algorithm>

namespace bolster {

namespace {

/// Verbs that are in the histories of projects, though no edit is called so any more.
[[maybe_unused]] constexpr const char* earlierVerbs[] = {QT_TRANSLATE_NOOP("Message", "Change the distance of %1"),
                                                         QT_TRANSLATE_NOOP("Message", "Change the voxels of %1")};

/// The elements of a kind with their names, for a choice.
template <class T>
std::pair<std::vector<ElementId>, QStringList> choices(const Design& design)
{
    std::pair<std::vector<ElementId>, QStringList> list;
    design.each<T>([&](ElementId id, const T&) {
        list.first.push_back(id);
        list.second << displayName(design, id);
    });
    return list;
}

int placeOf(const std::vector<ElementId>& ids, std::optional<ElementId> id)
{
    const auto found = id ? std::find(ids.begin(), ids.end(), *id) : ids.end();
    return found == ids.end() ? -1 : static_cast<int>(found - ids.begin());
}

} // namespace

void InspectorForms::addFrameChoice(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Cushion> cushion(m_document, ids, form);
    const auto [frames, names] = choices<Frame>(m_document.design());
    form.addChoice(
        tr("Frame"), names,
        [cushion, frames = frames] {
            return placeOf(frames, cushion.shared([](const Cushion& c) { return c.frame; }));
        },
        [cushion, frames = frames](int chosen) {
            cushion.change(QT_TRANSLATE_NOOP("Message", "Change the frame of %1"),
                           [&](Cushion& c) { c.frame = frames[static_cast<std::size_t>(chosen)]; });
        });
}

/// Everything, or the cover that one patch is sewn to.
void InspectorForms::addCoverChoice(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Cushion> cushion(m_document, ids, form);
    auto [patches, names] = choices<Patch>(m_document.design());
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

void InspectorForms::addCushion(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Cushion> cushion(m_document, ids, form);
    cushion.name(tr("Name"));
    cushion.field(&Cushion::enabled);
    addFrameChoice(form, ids);
    form.explain(tr("The frame that is padded"));
    addCushionParts(form, ids);
    addCoverChoice(form, ids);
    form.explain(tr("Which cover the padding presses outwards"));
    cushion.field(&Cushion::dilation);
    form.explain(tr("How thick the padding around the frame is"));
    cushion.field(&Cushion::strength);
    form.explain(tr("How hard the padding presses the cover outwards; from about 2 on it gives no more"));
    cushion.field(&Cushion::distance);
    form.explain(tr("How padding presses that is aslant to width, depth and height: harder fills the cover more"));
    cushion.field(&Cushion::voxel);
    form.explain(tr("How finely the frame is looked at: what is thinner may stay without padding"));
    if (!cushion.several())
        addVoxelNote(form, ids.front());
}

void InspectorForms::addFoam(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Foam> foam(m_document, ids, form);
    foam.name(tr("Name"));
    const auto [cushions, names] = choices<Cushion>(m_document.design());
    form.addChoice(
        tr("Cushion"), names,
        [foam, cushions = cushions] {
            return placeOf(cushions, foam.shared([](const Foam& f) { return f.cushion; }));
        },
        [foam, cushions = cushions](int chosen) {
            foam.change(QT_TRANSLATE_NOOP("Message", "Change the cushion of %1"),
                        [&](Foam& f) { f.cushion = cushions[static_cast<std::size_t>(chosen)]; });
        });
    if (foam.shared([](const Foam& f) { return f.shape == Foam::Shape::Mesh; }) != false) {
        foam.info(tr("File"), [](const Design&, const Foam& f) { return QString::fromStdString(f.file); });
    } else {
        foam.choiceBut(Foam::Shape::Mesh, &Foam::shape); // that is another file, not another shape
        foam.field(&Foam::size);
    }
    addPlacementFields(form, foam);
    foam.field(&Foam::cut);
    form.explain(tr("Takes this shape out of the cushion instead of adding it"));
    foam.field(&Foam::dilation);
    form.explain(tr("How thick the padding around this foam is"));
    foam.field(&Foam::strength);
    form.explain(tr("How hard this foam presses the cover outwards; from about 2 on it gives no more"));
}

} // namespace bolster
