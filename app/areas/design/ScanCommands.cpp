#include "ScanCommands.h"

#include "Ask.h"
#include "Commands.h"
#include "CoverAtRest.h"
#include "CoverView.h"
#include "Document.h"
#include "ImportFlow.h"
#include "Inspector.h"
#include "ScanEdits.h"
#include "ScanLink.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "StatusLine.h"
#include "Translated.h"

#include <QMenu>
#include <QPointer>
#include <QProgressDialog>

namespace bolster {

ScanCommands::ScanCommands(Commands& commands, Document& document, Selection& selection, ScanLink& scans,
                           ImportFlow& imports, CoverView& coverView, Inspector& inspector, StatusLine& status,
                           CoverAtRest& cover, QWidget& window)
    : m_commands(commands)
    , m_cover(cover)
    , m_document(document)
    , m_selection(selection)
    , m_scans(scans)
    , m_imports(imports)
    , m_coverView(coverView)
    , m_status(status)
    , m_window(window)
{
    add();
    commands.menu("scan")->setToolTipsVisible(true);
    connect(&inspector, &Inspector::framePiecesPointedAt, &coverView.shown(), &ShownScene::showFramePieces);
    connect(&inspector, &Inspector::scanWish, this, &ScanCommands::work);
}

void ScanCommands::add()
{
    const auto any = [this] {
        bool found = false;
        m_document.design().each<Scan>([&](ElementId, const Scan&) { found = true; });
        return found;
    };
    const auto cut = [this] {
        bool found = false;
        m_document.design().each<Scan>([&](ElementId, const Scan& scan) { found = found || !scan.cuts.empty(); });
        return found;
    };
    m_commands.add({{.id = "scan.align",
                     .text = tr("A&lign \u2026"),
                     .keys = {Qt::CTRL | Qt::ALT | Qt::Key_L},
                     .tip = tr("Click three places of the scan and where each belongs; the rest is found"),
                     .places = {"scan/1"},
                     .enabled = any,
                     .does = wishes(ScanWish::Align)},
                    {.id = "scan.place",
                     .formerly = "place-on-the-cover",
                     .text = tr("&Place on the cover"),
                     .keys = {Qt::CTRL | Qt::ALT | Qt::Key_P},
                     .tip = tr("Moves and turns the scan so that it lies on the cover as well as it can"),
                     .places = {"scan/1"},
                     .enabled = any,
                     .does = wishes(ScanWish::FitPlacement)},
                    {.id = "scan.cut",
                     .formerly = "cut-away",
                     .text = tr("&Cut away \u2026"),
                     .keys = {Qt::CTRL | Qt::ALT | Qt::Key_X},
                     .tip = tr("Drag a rectangle in the 3D view over what is to be cut away of the scan"),
                     .places = {"scan/2"},
                     .enabled = any,
                     .does = wishes(ScanWish::CutAway)},
                    {.id = "scan.keep",
                     .formerly = "keep-only",
                     .text = tr("&Keep only \u2026"),
                     .keys = {Qt::CTRL | Qt::ALT | Qt::Key_K},
                     .tip = tr("Drag a rectangle in the 3D view around what is to be kept of the scan"),
                     .places = {"scan/2"},
                     .enabled = any,
                     .does = wishes(ScanWish::KeepOnly)},
                    {.id = "scan.keep-around-cover",
                     .formerly = "keep-around-the-cover",
                     .text = tr("Keep &around the cover"),
                     .keys = {Qt::CTRL | Qt::ALT | Qt::Key_A},
                     .tip = tr("Cuts away what is farther from the cover than the threshold"),
                     .places = {"scan/2"},
                     .enabled = any,
                     .does = wishes(ScanWish::KeepAroundCover)},
                    {.id = "scan.remove-cuts",
                     .formerly = "remove-all-cuts",
                     .text = tr("&Remove all cuts"),
                     .keys = {Qt::CTRL | Qt::ALT | Qt::Key_R},
                     .tip = tr("Brings back all that was cut away of the scan"),
                     .places = {"scan/2"},
                     .enabled = cut,
                     .does = wishes(ScanWish::ShowAll)},
                    {.id = "scan.replace",
                     .formerly = "choose-another-file",
                     .text = tr("Choose another &file \u2026"),
                     .tip = tr("Reads the scan from another file"),
                     .places = {"scan/3"},
                     .enabled = any,
                     .does = [this] { onTheScan([this](ElementId scan) { m_imports.replaceFile(scan); }); }}});
}

std::function<void()> ScanCommands::wishes(ScanWish wish)
{
    return [this, wish] { onTheScan([this, wish](ElementId scan) { work(scan, wish); }); };
}

/// The one that is selected, or the only one, which is selected then.
void ScanCommands::onTheScan(const std::function<void(ElementId)>& act)
{
    m_document.cancelGesture();
    const Design& design = m_document.design();
    std::vector<ElementId> scans = selectedOf<Scan>(design, m_selection.elements());
    if (scans.empty())
        design.each<Scan>([&](ElementId id, const Scan&) { scans.push_back(id); });
    if (scans.size() != 1) {
        m_status.flash(tr("Select the scan that is meant."));
        return;
    }
    m_selection.set({scans.front()});
    act(scans.front());
}

void ScanCommands::work(ElementId scan, ScanWish wish)
{
    m_document.cancelGesture();
    switch (wish) {
    case ScanWish::Align:
        m_commands["layer.scans"]->setChecked(true);
        for (const char* const map : {"map.strain", "map.along", "map.across", "map.shear", "map.curvature",
                                      "map.thickness", "map.deviation"})
            m_commands[map]->setChecked(false); // beside one no scans are shown
        askForPlaces(scan, {});
        break;
    case ScanWish::FitPlacement:
        fitPlacement(scan);
        break;
    case ScanWish::CutAway:
    case ScanWish::KeepOnly:
        m_commands["layer.scans"]->setChecked(true); // else there is nothing to be seen of what is cut
        m_coverView.startScanCut(scan, wish == ScanWish::KeepOnly);
        break;
    case ScanWish::KeepAroundCover:
        m_scans.keepAroundCover(scan);
        break;
    case ScanWish::ShowAll:
        m_document.commit(edits::removeCuts(m_document.design(), scan));
        break;
    }
}

/// A dialog from which it can be stopped, until it says how it went.
ScanJob ScanCommands::watched(const QString& begun, const std::function<QString(int)>& step)
{
    QProgressDialog* progress = openProgress(&m_window, begun).dialog;
    ScanJob job;
    connect(progress, &QProgressDialog::canceled, this, [stop = job.stop]() mutable { stop.request_stop(); });
    job.progress = [progress = QPointer(progress), step](int iteration) {
        if (progress)
            progress->setLabelText(step(iteration));
    };
    job.done = [this, progress = QPointer(progress)](const Message& said) {
        closeProgress(progress);
        if (!said.empty())
            m_status.flash(translated(said));
    };
    return job;
}

void ScanCommands::fitPlacement(ElementId scan)
{
    m_cover.then([this, scan] { // one that still moves is not where the scan belongs
        m_scans.fitPlacement(scan, watched(tr("Placing the scan on the cover \u2026"), [](int iteration) {
                                 return tr("Placing the scan on the cover: step %1").arg(iteration);
                             }));
    });
}

void ScanCommands::askForPlaces(ElementId scan, const std::vector<ScanMark>& marks)
{
    m_coverView.startScanAlign(
        scan, [this](ElementId aligned, const std::vector<ScanMark>& clicked) { align(aligned, clicked); }, marks);
}

/// Places that don't fit are not lost: the last one can be given again, or more of them taken back.
void ScanCommands::align(ElementId scan, const std::vector<ScanMark>& marks)
{
    const ScanJob job = watched(tr("Aligning the scan \u2026"),
                                [](int iteration) { return tr("Aligning the scan: step %1").arg(iteration); });
    if (!m_scans.align(scan, marks, job)) // afterwards: the tool that was given them is still at work
        QMetaObject::invokeMethod(
            this, [this, scan, marks] { askForPlaces(scan, marks); }, Qt::QueuedConnection);
}

} // namespace bolster
