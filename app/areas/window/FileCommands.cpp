#include "FileCommands.h"

#include "Ask.h"
#include "Commands.h"
#include "CoverAtRest.h"
#include "CoverView.h"
#include "FabricLink.h"
#include "FileFlows.h"
#include "RenderDialog.h"
#include "SolverLink.h"
#include "ViewPrint.h"

#include <algorithm>

namespace bolster {

FileCommands::FileCommands(Commands& commands, FileFlows& files, DesignSession& session, SolverLink& solver,
                           CoverAtRest& cover, CoverView& coverView, FabricLink& fabrics, QWidget& window)
    : m_files(files)
    , m_session(session)
    , m_solver(solver)
    , m_cover(cover)
    , m_coverView(coverView)
    , m_fabrics(fabrics)
    , m_window(window)
{
    addOpening(commands);
    addSaving(commands);
    addExchange(commands);
    connect(&solver, &SolverLink::surfaceChanged, this, [&commands] {
        commands.update({"file.export-surface", "file.export-cover", "file.export-foam", "file.render-picture"});
    });
}

void FileCommands::addOpening(Commands& commands)
{
    commands.add({{.id = "file.new",
                   .formerly = "new",
                   .text = tr("&New"),
                   .icon = "new",
                   .keys = {QKeySequence::New},
                   .places = {"file/1"},
                   .bar = 101,
                   .does = [this] { m_files.opening.startNew(); }},
                  {.id = "file.open",
                   .formerly = "open",
                   .text = tr("&Open \u2026"),
                   .icon = "open",
                   .keys = {QKeySequence::Open},
                   .places = {"file/1"},
                   .bar = 102,
                   .does = [this] { m_files.opening.open(); }},
                  {.id = "file.quit",
                   .formerly = "quit",
                   .text = tr("&Quit"),
                   .keys = {Qt::CTRL | Qt::Key_Q},
                   .places = {"file/5"},
                   .does = [this] { m_window.close(); }}});
    commands.add(MenuPlace{"file.recent", tr("Open &recent"), "file/1",
                           [this](QMenu& menu) { m_files.opening.fillRecent(menu); }});
    commands.add(MenuPlace{"file.unsaved", tr("&Unsaved work"), "file/1",
                           [this](QMenu& menu) { m_files.left.fillUnsaved(menu); }});
    commands.add(MenuPlace{"file.samples", tr("Sa&mples"), "file/1"});
    m_files.opening.fillSamples(*commands.menu("file.samples"));
}

void FileCommands::addSaving(Commands& commands)
{
    commands.add({{.id = "file.save",
                   .formerly = "save",
                   .text = tr("&Save"),
                   .icon = "save",
                   .keys = {QKeySequence::Save},
                   .places = {"file/2"},
                   .bar = 103,
                   .does = [this] { m_files.saving.save(); }},
                  {.id = "file.save-as",
                   .formerly = "save-as",
                   .text = tr("Save &as \u2026"),
                   .icon = "save-as",
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_S},
                   .places = {"file/2"},
                   .does = [this] { m_files.saving.saveAs(); }}});
    commands.add(MenuPlace{"file.copy", tr("Save a &copy"), "file/2"});
    commands.add({{.id = "file.copy-everything",
                   .formerly = "with-everything",
                   .text = tr("With &everything \u2026"),
                   .places = {"file.copy/1"},
                   .does = [this] { m_files.saving.saveCopy({}); }},
                  {.id = "file.copy-without-history",
                   .formerly = "without-history",
                   .text = tr("Without &history \u2026"),
                   .places = {"file.copy/1"},
                   .does = [this] { m_files.saving.saveCopy({.withHistory = false}); }},
                  {.id = "file.copy-without-scans",
                   .formerly = "without-history-and-scans",
                   .text = tr("Without history and &scans \u2026"),
                   .places = {"file.copy/1"},
                   .does = [this] { m_files.saving.saveCopy({.withHistory = false, .withScans = false}); }},
                  {.id = "file.revert",
                   .formerly = "revert-to-saved",
                   .text = tr("Re&vert to saved"),
                   .places = {"file/2"},
                   .enabled =
                       [this] {
                           const Document& document = m_session.document();
                           return m_files.saving.hasSaved() && document.history().current() != document.saved();
                       },
                   .does = [this] { m_files.saving.revert(); }}});
}

void FileCommands::addExchange(Commands& commands)
{
    const auto patches = [this] {
        const auto& elements = m_session.document().design().elements();
        return std::ranges::any_of(elements,
                                   [](const auto& e) { return std::holds_alternative<Patch>(*e.second); });
    };
    const auto covered = [this] { return m_solver.surface() != nullptr; };
    commands.add({{.id = "file.import-frame",
                   .formerly = "import-frame",
                   .text = tr("&Import frame \u2026"),
                   .icon = "import-frame",
                   .keys = {Qt::CTRL | Qt::Key_I},
                   .places = {"file/3"},
                   .does = [this] { m_files.imports.importFrame(); }},
                  {.id = "file.import-scan",
                   .formerly = "import-scan",
                   .text = tr("Impor&t scan \u2026"),
                   .icon = "import-scan",
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_I},
                   .places = {"file/3"},
                   .does = [this] { m_files.imports.importScan(); }},
                  {.id = "file.import-pattern",
                   .text = tr("Import pattern (DX&F, SVG) \u2026"),
                   .icon = "patch",
                   .keys = {Qt::CTRL | Qt::ALT | Qt::Key_I},
                   .places = {"file/3"},
                   .does = [this] { m_files.imports.importPattern(); }},
                  {.id = "file.export-surface",
                   .formerly = "export-surface",
                   .text = tr("&Export surface \u2026"),
                   .icon = "export",
                   .keys = {Qt::CTRL | Qt::Key_E},
                   .places = {"file/4"},
                   .enabled = covered,
                   .does = [this] { m_cover.then([this] { m_files.exports.exportSurface(m_solver.surface()); }); }},
                  {.id = "file.export-cover",
                   .text = tr("Export cover (&HTML, glTF, STL) \u2026"),
                   .icon = "export",
                   .places = {"file/4"},
                   .enabled = covered,
                   .does =
                       [this] {
                           m_cover.then(
                               [this] { m_files.exports.exportCover(m_solver.surface(), m_fabrics.baker()); });
                       }},
                  {.id = "file.export-foam",
                   .text = tr("Export foam &body \u2026"),
                   .places = {"file/4"},
                   .enabled = covered,
                   .does = [this] { m_cover.then([this] { m_files.exports.exportFoam(m_solver.surface()); }); }},
                  {.id = "file.export-pattern",
                   .text = tr("E&xport pattern \u2026"),
                   .icon = "patch",
                   .keys = {Qt::CTRL | Qt::ALT | Qt::Key_E},
                   .places = {"file/4"},
                   .enabled = patches,
                   .does =
                       [this] {
                           m_files.exports.exportPattern(
                               [this] { return m_solver.surface() ? m_coverView.grabCover() : QImage(); });
                       }},
                  {.id = "file.export-picture",
                   .formerly = "export-picture",
                   .text = tr("Export &picture \u2026"),
                   .icon = "picture",
                   .places = {"file/4"},
                   .does = [this] { exportPicture(); }},
                  {.id = "file.render-picture",
                   .formerly = "render-picture",
                   .text = tr("Ren&der picture \u2026"),
                   .icon = "picture",
                   .keys = {Qt::Key_F12},
                   .places = {"file/4"},
                   .enabled = covered,
                   .does = [this] { m_cover.then([this] { renderPicture(); }); }},
                  {.id = "file.print-view",
                   .text = tr("Print view \u2026"),
                   .keys = {QKeySequence::Print},
                   .places = {"file/4"},
                   .does = [this] { printView(); }}});
}

void FileCommands::printView()
{
    const auto print = [this] { printSheet(&m_window, sheetOf(m_coverView, m_session.title())); };
    if (m_solver.surface())
        m_cover.then(print);
    else
        print();
}

void FileCommands::exportPicture()
{
    const auto take = [this] { m_files.exports.exportPicture(m_coverView.grabPicture()); };
    if (m_solver.surface())
        m_cover.then(take);
    else
        take();
}

void FileCommands::renderPicture()
{
    const SurfaceMeshPtr& surface = m_solver.surface();
    if (!surface)
        return;
    RenderDialog::Subject subject{surface,
                                  m_session.document().design(),
                                  m_session.files(),
                                  m_fabrics.baker(),
                                  m_fabrics.bakedByNow(),
                                  m_session.title(),
                                  m_coverView.navigation().camera(),
                                  m_files.exports.proposedPicture()};
    openDialog(new RenderDialog(std::move(subject), &m_window));
}

} // namespace bolster
