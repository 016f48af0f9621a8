// What the inspector shows of mirror twins and of the mirror.
#include "InspectorForms.h"
#include "InspectorSubject.h"
#include "PlacementFields.h"
#include "SelectionEdits.h"
#include "TwinEdits.h"
#include "Twins.h"

#include <array>

namespace bolster {

namespace {

const NumberBox::Range directionRange{{}, 4, -1e7, 1e7, 0.1};

} // namespace

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

void InspectorForms::addMirroredSewing(PropertyForm& form, ElementId id) const
{
    const Design& design = m_document.design();
    if (!design.find<Seam>(id) && !design.find<FixationSeam>(id) && !design.find<OutlineTrim>(id))
        return;
    const bool released = edits::sewingReleased(design, id);
    if (!released && edits::mirroredElement(design, id) == settingsId)
        return;
    form.addInfo(tr("Mirror image"), [this, id] {
        const Design& now = m_document.design();
        const ElementId other = edits::mirroredElement(now, id);
        if (edits::sewingReleased(now, id))
            return tr("released");
        return other == id           ? tr("itself")
               : other == settingsId ? QStringLiteral("\u2013")
                                     : displayName(now, other);
    });
    if (released)
        form.addButton(tr("Re-lin&k to its mirror image"),
                       [this, id] { m_document.commit(relinkedSewing(m_document.design(), id)); });
    else
        form.addButton(tr("Re&lease from its mirror image"),
                       [this, id] { m_document.commit(releasedSewing(m_document.design(), id)); });
}

void InspectorForms::addTwin(PropertyForm& form, ElementId id) const
{
    addMirroredSewing(form, id);
    if (twinOf(m_document.design(), id) == settingsId)
        return;
    form.addInfo(tr("Twin of"), [this, id] {
        const ElementId other = twinOf(m_document.design(), id);
        return other == settingsId ? QStringLiteral("\u2013") : displayName(m_document.design(), other);
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

void InspectorForms::addSymmetry(PropertyForm& form) const
{
    const auto change = [this](const std::function<void(std::optional<Symmetry>&)>& set) {
        Settings settings = m_document.design().settings();
        set(settings.symmetry);
        m_document.commit(edits::changeSettings(m_document.design(), settings));
    };
    form.addCheck(
        tr("Symmetric design"), [this] { return m_document.design().settings().symmetry.has_value(); },
        [change](bool on) {
            change([on](std::optional<Symmetry>& s) { s = on ? std::optional(Symmetry()) : std::nullopt; });
        });
    const auto row = [&](const QString& label, const NumberBox::Range& range, int count, auto member) {
        form.addNumbers(
            label, range, count, [this, member](int i) { return (symmetryOf(m_document.design()).*member)[i]; },
            [change, member](int i, double value) {
                change([&](std::optional<Symmetry>& s) {
                    if (!s)
                        s = Symmetry();
                    ((*s).*member)[i] = value;
                });
            });
    };
    row(tr("Plane through"), lengthRange, 3, &Symmetry::planePoint);
    row(tr("Normal"), directionRange, 3, &Symmetry::planeNormal);
    row(tr("Axis through"), lengthRange, 2, &Symmetry::axisPoint);
    row(tr("Direction"), directionRange, 2, &Symmetry::axisDirection);
}

} // namespace bolster
