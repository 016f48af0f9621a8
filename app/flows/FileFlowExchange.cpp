// Importing frames, scans and patterns, exporting patterns.
#include "Ask.h"
#include "Background.h"
#include "ExportPatternDialog.h"
#include "FileFlow.h"
#include "FileFormats.h"
#include "FileImportDialog.h"
#include "FixationsLeft.h"
#include "FrameSimplifying.h"
#include "ImportPatternDialog.h"
#include "Jobs.h"
#include "PatternImport.h"
#include "TemporaryFile.h"
#include "Translated.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QProgressBar>
#include <QProgressDialog>

#include <set>

namespace bolster {

namespace {

/// A frame that shows all but these parts. Pieces of parts that were hidden before stay so; of whole parts the user
/// has said it.
Element withoutParts(Element element, const FileContent& content, const std::vector<std::string>& unwanted)
{
    Frame* const frame = std::get_if<Frame>(&element);
    if (!frame)
        return element;
    std::set<std::string> there;
    for (const TriangleMesh::Part& part : content.mesh->parts)
        there.insert(part.name);
    std::erase_if(frame->hiddenParts, [&](const std::string& name) { return there.contains(name); });
    frame->hiddenParts.insert(frame->hiddenParts.begin(), unwanted.begin(), unwanted.end());
    return element;
}

QString meshFilter()
{
    return FileFlow::tr("Frames (%1)").arg(patternsOf(FileUse::Frame));
}

QString scanFilter()
{
    return FileFlow::tr("Scans (%1)").arg(patternsOf(FileUse::Scan));
}

} // namespace

void FileFlow::importFrame(const QString& path)
{
    import(Frame{}, tr("Import frame"), meshFilter(), path);
}

void FileFlow::importScan(const QString& path)
{
    Scan scan;
    scan.enabled = false; // until it is aligned the cover would be pulled to the wrong place
    import(scan, tr("Import scan"), scanFilter(), path);
}

void FileFlow::replaceFile(ElementId id)
{
    const ElementPtr element = m_session.document().design().element(id);
    if (!element || !elementPlacement(*element))
        return;
    const QString filter = fileKind(*element) == FileKind::Mesh ? meshFilter() : scanFilter();
    askForFile(m_window, tr("Choose another file"), startFolder(), filter,
               [this, element, id](const QString& file) { importNow(file, *element, id); });
}

/// A new element like `element`, named after its file.
template <class T>
void FileFlow::import(const T& element, const QString& title, const QString& filter, const QString& path)
{
    const auto take = [this, element](const QString& file) {
        T named = element;
        named.name = QFileInfo(file).completeBaseName().toStdString();
        importNow(file, std::move(named), {});
    };
    if (path.isEmpty())
        askForFile(m_window, title, startFolder(), filter, take);
    else
        take(path);
}

QString FileFlow::readingText(const QString& path)
{
    return tr("Reading %1 \u2026").arg(QFileInfo(path).fileName());
}

template <class Result, class Read, class Done>
void FileFlow::readInBackground(const QString& path, Read read, Done done)
{
    withProgress<Result>(readingText(path), std::move(read), std::move(done));
}

/// Works with progress that can be cancelled; `done` gets what came of it unless it was.
template <class Result, class Read, class Done>
void FileFlow::withProgress(const QString& text, Read read, Done done)
{
    constexpr int steps = 100;
    const auto [progress, bar] = openProgress(m_window, text, steps);
    std::stop_source stop;
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    connect(progress, &QObject::destroyed, [stop]() mutable { stop.request_stop(); }); // with its window
    auto job = std::make_shared<RunningJob>(text, [progress = QPointer(progress)] {
        if (progress)
            progress->cancel();
    });
    const auto report = [this, shown = std::make_shared<int>(0), bar = QPointer(bar),
                         job = std::weak_ptr(job)](double share) {
        const int step = static_cast<int>(share * steps);
        if (step <= std::exchange(*shown, step))
            return;
        QMetaObject::invokeMethod(this, [bar, step, job] {
            if (bar)
                bar->setValue(step);
            if (const auto running = job.lock())
                running->report(double(step) / steps);
        });
    };
    inBackground<Result>([read, watch = ImportWatch{stop.get_token(), report, {}}] {
        return read(watch);
    }).then(this, [done, job, progress = QPointer(progress)](const Result& result) mutable {
        const bool cancelled = !progress || progress->wasCanceled();
        closeProgress(progress);
        job.reset();
        if (!cancelled)
            done(result);
    });
}

void FileFlow::importNow(const QString& path, const Element& element, std::optional<ElementId> replaced)
{
    readInBackground<ImportedFile>(
        path,
        [kind = fileKind(element), path](const ImportWatch& watch) {
            return importFromElsewhere(kind, path, watch);
        },
        [this, path, element, replaced](const ImportedFile& imported) {
            if (imported.content)
                place(path, imported, element, replaced);
            else if (!imported.problem.empty())
                failImport(path, imported.problem);
        });
}

void FileFlow::importPattern(const QString& path)
{
    if (path.isEmpty()) {
        askForFile(m_window, tr("Import pattern"), startFolder(),
                   tr("Patterns (%1)").arg(patternsOf(FileUse::Pattern)),
                   [this](const QString& file) { importPattern(file); });
        return;
    }
    readInBackground<ImportedDrawing>(
        path, [path](const ImportWatch& watch) { return importDrawing(path, watch); },
        [this, path](const ImportedDrawing& imported) {
            if (imported.drawing)
                choosePieces(path, *imported.drawing);
            else if (!imported.problem.empty())
                failImport(path, imported.problem);
        });
}

void FileFlow::choosePieces(const QString& path, const Drawing& drawing)
{
    auto* dialog = new ImportPatternDialog(drawing, path, m_window);
    connect(dialog, &QDialog::accepted, this, [this, path, dialog] {
        if (const auto pattern = dialog->pattern())
            addPattern(path, pattern, dialog->choice());
    });
    openDialog(dialog);
}

/// Curves are fitted in the background, to the design as it is then: an edit that comes in between is kept.
void FileFlow::addPattern(const QString& path, const std::shared_ptr<const FoundPattern>& pattern,
                          const PatternChoice& choice)
{
    const Design design = m_session.document().design();
    readInBackground<ImportedPattern>(
        path, [design, pattern, choice](const ImportWatch&) { return patternEdit(design, *pattern, choice); },
        [this, path, design, pattern, choice](const ImportedPattern& imported) {
            Document& document = m_session.document();
            document.cancelGesture();
            if (!(document.design() == design)) {
                addPattern(path, pattern, choice);
                return;
            }
            QStringList notes;
            for (const Message& note : imported.notes)
                notes << asSentence(translated(note));
            if (imported.edit.empty()) {
                failImport(path, imported.notes.empty()
                                     ? Message{QT_TRANSLATE_NOOP("Message", "there is no piece in it"), {}}
                                     : imported.notes.front());
                return;
            }
            document.commit(imported.edit);
            emit patternImported(imported.patches);
            if (!notes.isEmpty())
                tell(m_window, QMessageBox::Information,
                     tr("The pattern is imported. What is otherwise than in the file:"),
                     notes.mid(0, 12).join(u'\n'));
        });
}

void FileFlow::place(const QString& path, const ImportedFile& file, const Element& element,
                     std::optional<ElementId> replaced)
{
    std::optional<Placement> before;
    PlacedMesh old;
    if (replaced) {
        before = *elementPlacement(element);
        const auto& meshes = m_session.files().meshes;
        if (const auto there = meshes.find(*replaced); there != meshes.end())
            old = {there->second, *before};
    }
    auto* dialog = new FileImportDialog(path, file.content, before, file.said, m_window);
    if (const Frame* const frame = std::get_if<Frame>(&element))
        dialog->offerParts(file.tree, frame->hiddenParts);
    if (old.mesh) {
        const Box3 size = placedBox(old.mesh->points, {.scale = old.placement.scale});
        dialog->replaces(size.isEmpty() ? 0 : size.sizes().maxCoeff());
    }
    dialog->warn(asSentence(translated(file.warning)));
    connect(dialog, &QDialog::accepted, this, [=, this] {
        const Element placed = *withPlacement(element, dialog->placement());
        const std::vector<std::string> unwanted = dialog->unwantedParts();
        const auto most = dialog->wantedTriangles();
        if (most || !file.beside.empty()) // a design's frame is one file
            writeAnew({path, file.content, placed, replaced, old}, unwanted, most);
        else
            addPlaced({path, file.content, withoutParts(placed, file.content, unwanted), replaced, old});
    });
    openDialog(dialog);
}

void FileFlow::writeAnew(const PlacedFile& file, const std::vector<std::string>& unwanted,
                         std::optional<std::size_t> triangles)
{
    const QString title = triangles ? tr("Simplifying %1 \u2026") : tr("Writing %1 \u2026");
    withProgress<SimplifiedFrame>(
        title.arg(QFileInfo(file.path).fileName()),
        [path = file.path, mesh = file.content.mesh, unwanted, triangles](const ImportWatch& watch) {
            return simplifiedFrame(path, *mesh, unwanted, triangles.value_or(mesh->triangles.size()), watch);
        },
        [this, file](const SimplifiedFrame& simplified) {
            PlacedFile fewer = file;
            fewer.path = simplified.path;
            fewer.content = simplified.content;
            std::get<Frame>(fewer.element).hiddenParts.clear(); // they are not in this file
            if (simplified.content)
                addPlaced(fewer);
            else if (!simplified.problem.empty())
                failImport(file.path, simplified.problem);
        });
}

void FileFlow::addPlaced(const PlacedFile& file)
{
    if (const Message problem = m_session.addWithFile(file.path, file.content, file.element, file.replaced);
        !problem.empty()) {
        failImport(file.path, problem);
        return;
    }
    emit imported(fileKind(file.element));
    if (file.replaced && file.content.mesh)
        tellFixationsOff(m_window, m_session.document().design(), file.old,
                         {file.content.mesh, *elementPlacement(file.element)});
}

void FileFlow::failImport(const QString& path, const Message& why)
{
    fail(tr("\"%1\" could not be imported.").arg(QFileInfo(path).fileName()), why);
}

void FileFlow::exportPattern(std::function<QImage()> takePicture)
{
    auto* dialog = new ExportPatternDialog(m_session.document().design(), name(), std::move(takePicture), m_window);
    connect(dialog, &ExportPatternDialog::placeWanted, this, &FileFlow::placeWanted);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const PatternOrder order = dialog->order();
        const QString ending = patternEnding(order.format);
        chooseTarget(tr("Export pattern"),
                     proposed(ending, order.format == PatternFormat::SewingSheet ? tr("-sewing") : tr("-pattern")),
                     tr("%1 (*.%2)").arg(ending.toUpper(), ending), {ending},
                     [this, order, picture = dialog->picture()](const QString& path) {
                         exportPatternTo(path, order, picture);
                     });
    });
    openDialog(dialog);
}

void FileFlow::exportPatternTo(const QString& path, const PatternOrder& order, const QImage& cover)
{
    withProgress<Message>(
        tr("Writing %1 \u2026").arg(QFileInfo(path).fileName()),
        [design = m_session.document().design(), path, order, cover](const ImportWatch& watch) -> Message {
            const std::string bytes = patternBytes(design, order, cover, {watch.stop, watch.progress});
            if (watch.stop.stop_requested())
                return {};
            removeLeftTemporaryFiles(QFileInfo(path).absolutePath());
            return replaceWholeFile(path, bytes);
        },
        [this, path](const Message& problem) {
            if (problem.empty()) {
                emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
                emit exported();
            } else {
                fail(tr("The pattern could not be exported."), problem);
            }
        });
}

} // namespace bolster
