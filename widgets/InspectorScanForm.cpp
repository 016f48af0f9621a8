// What the inspector shows of a scan.
#include "InspectorForms.h"
#include "PlacementRows.h"

namespace bolster {

void InspectorForms::addScan(PropertyForm& form, ElementId id) const
{
    const InspectorSubject<Scan> scan(m_document, id, form);
    scan.name(tr("Name"));
    scan.info(tr("File"), [](const Design&, const Scan& s) { return QString::fromStdString(s.file); });
    scan.check(tr("Fit the cover to it"), &Scan::enabled, QT_TRANSLATE_NOOP("Message", "Switch the fit to %1"));
    scan.number(tr("Strength"), {{}, 2, 0, 100, 0.25}, &Scan::strength,
                QT_TRANSLATE_NOOP("Message", "Change the strength of %1"));
    scan.number(tr("Threshold"), {QStringLiteral(" mm"), 1, 0.1, 1e4, 5}, &Scan::threshold,
                QT_TRANSLATE_NOOP("Message", "Change the threshold of %1"));
    scan.choice(tr("Pull"), {tr("Along the normal"), tr("To the point itself")}, &Scan::target,
                QT_TRANSLATE_NOOP("Message", "Change how %1 pulls"));
    PlacementRows::add(scan, form);
    form.addButton(tr("Choose another file \u2026"), [this, id] { m_chooseFile(id); });
}

} // namespace bolster
