// What the inspector shows of mirror twins and of the mirror.
#include "InspectorForms.h"
#include "InspectorSubject.h"
#include "PlacementFields.h"
#include "TwinEdits.h"
#include "Twins.h"

#include <array>

namespace bolster {

namespace {

const NumberBox::Range directionRange{{}, 4, -1e7, 1e7, 0.1};

} // namespace

void InspectorForms::addTwin(PropertyForm& form, ElementId id) const
{
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
    form.addButton(tr("Unlink from its twin"),
                   [this, id] { m_document.commit(edits::unlinkTwins(m_document.design(), std::array{id})); });
    if (!releasedPoints(m_document.design(), id).empty())
        form.addButton(tr("Re-link all points"), [this, id] {
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
