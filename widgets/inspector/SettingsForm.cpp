#include "SettingsForm.h"

#include "CuttingForms.h"
#include "Icons.h"
#include "PatternSize.h"
#include "PlacementFields.h"
#include "StretchLength.h"
#include "Twins.h"
#include "Units.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

const NumberBox::Range directionRange{{}, 4, -1e7, 1e7, 0.1};

/// Two digits: more would not be true.
QString aboutText(double count)
{
    const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) - 1));
    return QLocale().toString(static_cast<qlonglong>(std::round(count / unit) * unit));
}

} // namespace

void SettingsForm::add(PropertyForm& form, const Ids&) const
{
    form.addHeading(kindWord(kindOf<Settings>()), icon(QStringLiteral("settings")));
    const InspectorSubject<Settings> settings(m_document, {settingsId}, form);
    settings.field(&Settings::edgeLength);
    form.addInfo(tr("Vertices"), [this] {
        const Design& design = m_document.design();
        return tr("about %1").arg(aboutText(vertexCount(patternArea(design), design.settings().edgeLength)));
    });
    form.explain(tr("How many points the cover has at this edge length: solving takes time and memory for each."));
    addSymmetry(form, settings);
    form.addInfo(tr("Patches"), [this] {
        int count = 0;
        m_document.design().each<Patch>([&](ElementId, const Patch&) { ++count; });
        return tr("%1, %2 in all").arg(count).arg(areaText(patternArea(m_document.design())));
    });
    form.addInfo(tr("Seams"), [this] {
        int count = 0;
        double length = 0;
        m_document.design().each<Seam>([&](ElementId, const Seam& seam) {
            ++count;
            length += stretchLength(m_document.design(), seam.a);
        });
        return tr("%1, %2 in all").arg(count).arg(longLengthText(length));
    });
    DesignCuttingSection::add(form, settings);
    form.addNote([] { return tr("Select something to see its properties."); });
}

/// Its numbers are those of the default until it is there.
void SettingsForm::addSymmetry(PropertyForm& form, const InspectorSubject<Settings>& settings)
{
    const char* const verb = Description<Settings>::added;
    form.addCheck(
        tr("Symmetric design"), [settings] { return settings.now().symmetry.has_value(); },
        [settings, verb](bool on) {
            settings.change(verb,
                            [on](Settings& s) { s.symmetry = on ? std::optional(Symmetry()) : std::nullopt; });
        });
    form.explain(
        tr("Twins are mirror images of each other. With this mark you say where the mirror stands; without "
           "it, it stands in the middle, between left and right."));
    const auto row = [&](const QString& label, const QString& tip, const NumberBox::Range& range, int count,
                         auto member) {
        form.addNumbers(
            label, range, count, [settings, member](int i) { return (symmetryOf(settings.design()).*member)[i]; },
            [settings, member, verb](int i, double value) {
                settings.change(verb, [&](Settings& s) {
                    s.symmetry = s.symmetry.value_or(Symmetry());
                    ((*s.symmetry).*member)[i] = value;
                });
            });
        form.explain(tip);
        form.nameRow(QStringLiteral("field.symmetry"));
    };
    row(tr("Plane through"), tr("A point of the plane in which the cover is mirrored"), lengthRange, 3,
        &Symmetry::planePoint);
    row(tr("Normal"), tr("The direction straight out of that plane"), directionRange, 3, &Symmetry::planeNormal);
    row(tr("Axis through"), tr("A point of the line of the pattern at which patches are mirrored"), lengthRange, 2,
        &Symmetry::axisPoint);
    row(tr("Direction"), tr("The direction of that line"), directionRange, 2, &Symmetry::axisDirection);
}

} // namespace bolster
