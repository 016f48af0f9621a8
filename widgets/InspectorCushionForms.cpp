// The inspector's forms for cushions and foam.
#include "InspectorForms.h"
#include "InspectorSubject.h"
#include "PlacementFields.h"

#include <algorithm>

namespace bolster {

namespace {

const NumberBox::Range paddingRange{QStringLiteral(" mm"), 2, 0, 1000, 5};
const NumberBox::Range strengthRange{{}, 3, 0, 10, 0.1};
// What the sliders cover; the boxes beside them take more.
constexpr double thickestPadding = 100;
constexpr double greatestForce = 2;

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
    cushion.check(tr("Pushes the cover"), &Cushion::enabled, QT_TRANSLATE_NOOP("Message", "Switch %1"));
    addFrameChoice(form, ids);
    form.explain(tr("The frame that is padded"));
    addCushionParts(form, ids);
    addCoverChoice(form, ids);
    form.explain(tr("Which cover the padding presses outwards"));
    cushion.slider(tr("Padding"), paddingRange, 0, thickestPadding, &Cushion::dilation,
                   QT_TRANSLATE_NOOP("Message", "Change the padding of %1"));
    form.explain(tr("How thick the padding around the frame is"));
    cushion.slider(tr("Strength"), strengthRange, 0, greatestForce, &Cushion::strength,
                   QT_TRANSLATE_NOOP("Message", "Change the strength of %1"));
    form.explain(tr("How hard the padding presses the cover outwards; from about 2 on it gives no more"));
    cushion.choice(tr("Slanted faces"), {tr("Press harder"), tr("Press like straight ones")}, &Cushion::distance,
                   QT_TRANSLATE_NOOP("Message", "Change the slanted faces of %1"));
    form.explain(tr("How padding presses that is aslant to width, depth and height: harder fills the cover more"));
    cushion.number(tr("Smallest detail"), {QStringLiteral(" mm"), 2, 0.5, 100, 1}, &Cushion::voxel,
                   QT_TRANSLATE_NOOP("Message", "Change the smallest detail of %1"));
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
        foam.choice(tr("Shape"), {tr("Box"), tr("Cylinder"), tr("Sphere")}, &Foam::shape,
                    QT_TRANSLATE_NOOP("Message", "Change the shape of %1"));
        foam.numbers(
            tr("Size"), {QStringLiteral(" mm"), 2, 1, 1e7, 5}, 3,
            [](Foam& f, int i) -> double& { return f.size[i]; },
            QT_TRANSLATE_NOOP("Message", "Change the size of %1"));
    }
    addPlacementFields(form, foam, {});
    foam.check(tr("Cut away"), &Foam::cut, QT_TRANSLATE_NOOP("Message", "Add or cut %1"));
    form.explain(tr("Takes this shape out of the cushion instead of adding it"));
    foam.slider(tr("Padding"), paddingRange, 0, thickestPadding, &Foam::dilation,
                QT_TRANSLATE_NOOP("Message", "Change the padding of %1"));
    form.explain(tr("How thick the padding around this foam is"));
    foam.slider(tr("Strength"), strengthRange, 0, greatestForce, &Foam::strength,
                QT_TRANSLATE_NOOP("Message", "Change the strength of %1"));
    form.explain(tr("How hard this foam presses the cover outwards; from about 2 on it gives no more"));
}

} // namespace bolster
