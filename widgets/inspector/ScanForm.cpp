#include "ScanForm.h"

#include "InspectorSubject.h"
#include "PlacementFields.h"
#include "ScanEdits.h"
#include "Units.h"

#include <QLocale>

namespace bolster {

void ScanForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Scan> scan(m_document, ids, form);
    scan.name();
    scan.info(tr("File"), [](const Design&, const Scan& s) { return QString::fromStdString(s.file); });
    if (!scan.several())
        addContents(form, ids.front());
    scan.field(&Scan::enabled);
    scan.field(&Scan::strength);
    scan.field(&Scan::threshold);
    scan.field(&Scan::target);
    if (!scan.several())
        addReport(form, ids.front());
    addPlacementFields(form, scan);
    if (scan.several())
        return;
    const ElementId id = ids.front();
    form.addButton(tr("Ali&gn \u2026"), [this, id] { m_wishes.workOnScan(id, ScanWish::Align); });
    form.addButton(tr("Place on &the cover"), [this, id] { m_wishes.workOnScan(id, ScanWish::FitPlacement); });
    addCuts(form, id);
    form.addButton(tr("Choose an&other file \u2026"), [this, id] { m_wishes.chooseFile(id); });
}

void ScanForm::addContents(PropertyForm& form, ElementId id) const
{
    form.addInfo(tr("Contents"), [this, id] {
        const auto* scan = m_document.design().find<Scan>(id);
        const auto found = m_sources.files.clouds.find(id);
        if (!scan || found == m_sources.files.clouds.end())
            return QStringLiteral("\u2013");
        const PointCloud& cloud = *found->second;
        const auto count = [](std::uint64_t number) { return QLocale().toString(static_cast<qulonglong>(number)); };
        const QString kept = count(cloud.points.size());
        return cloud.thinnedFrom == 0
                   ? tr("%1 points").arg(kept)
                   : tr("%1 of %2 points, one every %3")
                         .arg(kept, count(cloud.thinnedFrom), lengthText(cloud.spacing * scan->scale));
    });
}

void ScanForm::addReport(PropertyForm& form, ElementId id) const
{
    const auto row = [&](const QString& label, const QString& tip, auto text) {
        form.addInfo(label, [this, id, text] {
            const auto found = m_sources.scanFigures.find(id);
            return found == m_sources.scanFigures.end() || found->second.coverage == 0 ? QStringLiteral("\u2013")
                                                                                       : text(found->second);
        });
        form.explain(tip);
    };
    const auto mm = [](double value) { return lengthText(value, 2); };
    const QString away = tr("Between the cover and the scan, where they are nearer than the threshold.");
    row(tr("Deviation"), away, [mm](const ScanFigures& f) { return tr("%1 rms").arg(mm(f.rms)); });
    row(tr("Median, 95 %"), tr("Half of what is measured, and 95 % of it, is no farther from the scan than that."),
        [mm](const ScanFigures& f) { return tr("%1, %2").arg(mm(f.median), mm(f.p95)); });
    row(tr("Largest"), away, [mm](const ScanFigures& f) { return mm(f.max); });
    row(tr("Coverage"), tr("How much of the cover has points of the scan near it."),
        [](const ScanFigures& f) { return percentText(f.coverage); });
    row(tr("Points"), tr("Of the scan, without what is cut away."),
        [](const ScanFigures& f) { return QLocale().toString(static_cast<qlonglong>(f.points)); });
}

void ScanForm::addCuts(PropertyForm& form, ElementId id) const
{
    const InspectorSubject<Scan> scan(m_document, {id}, form);
    form.addNumber(
        tr("Floor at"), lengthRange, [scan] { return edits::floorOf(scan.now()).value_or(0); },
        [this, id](double height) { m_document.commit(edits::cutFloor(m_document.design(), id, height)); });
    scan.info(tr("Cuts"), [](const Design&, const Scan& s) { return QString::number(s.cuts.size()); });
    form.addButton(tr("Cut awa&y \u2026"), [this, id] { m_wishes.workOnScan(id, ScanWish::CutAway); });
    form.addButton(tr("&Keep only \u2026"), [this, id] { m_wishes.workOnScan(id, ScanWish::KeepOnly); });
    form.addButton(tr("Keep aroun&d the cover"),
                   [this, id] { m_wishes.workOnScan(id, ScanWish::KeepAroundCover); });
    form.addButton(tr("Remove a&ll cuts"), [this, id] { m_wishes.workOnScan(id, ScanWish::ShowAll); });
}

} // namespace bolster
