#include "SettingsForm.h"

#include "CuttingForms.h"
#include "Icons.h"
#include "InspectorSubject.h"
#include "PlacementFields.h"
#include "StretchLength.h"
#include "Twins.h"
#include "Units.h"

#include <cmath>

namespace bolster {

namespace {

const NumberBox::Range directionRange{{}, 4, -1e7, 1e7, 0.1};

} // namespace

void SettingsForm::add(PropertyForm& form, const Ids&) const
{
    form.addHeading(kindWord(kindOf<Settings>()), icon(QStringLiteral("settings")));
    const Settings usual;
    const DescribedField edge = describedField(usual, &usual.edgeLength);
    form.addNumber(
        edge.label(), edge.range(), [this] { return m_document.design().settings().edgeLength; },
        [this](double value) {
            Settings settings = m_document.design().settings();
            settings.edgeLength = value;
            m_document.commit(edits::changeSettings(m_document.design(), settings));
        });
    addSymmetry(form);
    form.addInfo(tr("Patches"), [this] {
        int count = 0;
        double area = 0; // mm^2
        m_document.design().each<Patch>([&](ElementId, const Patch& patch) {
            ++count;
            area += patch.outline.empty() ? 0 : std::abs(patch.outline.signedArea());
        });
        return tr("%1, %2 m\u00b2 in all").arg(count).arg(decimalText(area * 1e-6, 2, true));
    });
    form.addInfo(tr("Seams"), [this] {
        int count = 0;
        double length = 0;
        m_document.design().each<Seam>([&](ElementId, const Seam& seam) {
            ++count;
            length += stretchLength(m_document.design(), seam.a);
        });
        return tr("%1, %2 m in all").arg(count).arg(decimalText(length * 1e-3, 2, true));
    });
    DesignCuttingSection::add(form, InspectorSubject<Settings>(m_document, {settingsId}, form));
    form.addNote([] { return tr("Select something to see its properties."); });
}

void SettingsForm::addSymmetry(PropertyForm& form) const
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
