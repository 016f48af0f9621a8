// Importing frames and scans, exporting surfaces and pictures.
#include "Ask.h"
#include "Background.h"
#include "ExportPatternDialog.h"
#include "FileFlow.h"
#include "FileImportDialog.h"
#include "ImportPatternDialog.h"
#include "PatternImport.h"
#include "SurfaceExport.h"
#include "Translated.h"
#include "WholeFile.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QProgressBar>
#include <QProgressDialog>

#include <algorithm>

namespace bolster {

namespace {

/// Pieces of parts that were hidden before stay so; of whole parts the user has said it.
std::vector<std::string> hiddenAfter(std::vector<std::string> before, const TriangleMesh& mesh,
                                     std::vector<std::string> unwanted)
{
    std::erase_if(before, [&](const std::string& name) {
        return std::ranges::any_of(mesh.parts, [&](const TriangleMesh::Part& part) { return part.name == name; });
    });
    unwanted.insert(unwanted.end(), before.begin(), before.end());
    return unwanted;
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
    import(Scan{}, tr("Import scan"), scanFilter(), path);
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

/// Reads with progress that can be cancelled; `done` gets what was read unless it was.
template <class Result, class Read, class Done>
void FileFlow::readInBackground(const QString& path, Read read, Done done)
{
    constexpr int steps = 100;
    const auto [progress, bar] = openProgress(m_window, readingText(path), steps);
    std::stop_source stop;
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    connect(progress, &QObject::destroyed, [stop]() mutable { stop.request_stop(); }); // with its window
    const auto report = [this, shown = std::make_shared<int>(0), bar = QPointer(bar)](double share) {
        const int step = static_cast<int>(share * steps);
        if (step > std::exchange(*shown, step))
            QMetaObject::invokeMethod(this, [bar, step] { return bar ? bar->setValue(step) : void(); });
    };
    inBackground<Result>([read, watch = ImportWatch{stop.get_token(), report, {}}] {
        return read(watch);
    }).then(this, [done, progress = QPointer(progress)](const Result& result) {
        const bool cancelled = !progress || progress->wasCanceled();
        closeProgress(progress);
        if (!cancelled)
            done(result);
    });
}

void FileFlow::importNow(const QString& path, const Element& element, std::optional<ElementId> replaced)
{
    readInBackground<ImportedFile>(
        path, [kind = fileKind(element), path](const ImportWatch& watch) { return importFile(kind, path, watch); },
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
                tell(m_window, QMessageBox::Information, tr("Not all of the pattern could be taken."),
                     notes.mid(0, 12).join(u'\n'));
        });
}

void FileFlow::place(const QString& path, const ImportedFile& file, const Element& element,
                     std::optional<ElementId> replaced)
{
    std::optional<Placement> before;
    if (replaced)
        before = *elementPlacement(element);
    auto* dialog = new FileImportDialog(path, file.content, before, file.said, m_window);
    if (const Frame* const frame = std::get_if<Frame>(&element))
        dialog->offerParts(file.tree, frame->hiddenParts);
    connect(dialog, &QDialog::accepted, this, [=, this] {
        Element placed = *withPlacement(element, dialog->placement());
        if (Frame* const frame = std::get_if<Frame>(&placed))
            frame->hiddenParts = hiddenAfter(frame->hiddenParts, *file.content.mesh, dialog->unwantedParts());
        if (const Message problem = m_session.addWithFile(path, file.content, placed, replaced); !problem.empty())
            failImport(path, problem);
        else
            emit imported(fileKind(element));
    });
    openDialog(dialog);
}

void FileFlow::failImport(const QString& path, const Message& why)
{
    fail(tr("\"%1\" could not be imported.").arg(QFileInfo(path).fileName()), why);
}

void FileFlow::exportSurface(const SurfaceMeshPtr& surface)
{
    if (!surface)
        return;
    chooseTarget(tr("Export surface"), proposed(QStringLiteral("obj"), tr("-cover")),
                 tr("OBJ (*.obj);;PLY (*.ply)"), {QStringLiteral("obj"), QStringLiteral("ply")},
                 [this, surface](const QString& path) { exportSurfaceTo(surface, path); });
}

void FileFlow::exportSurfaceTo(const SurfaceMeshPtr& surface, const QString& path)
{
    const bool ply = path.endsWith(QLatin1String(".ply"), Qt::CaseInsensitive);
    inBackground<Message>([surface, design = m_session.document().design(), path, ply] {
        return ply ? exportPly(*surface, design, path) : exportObj(*surface, design, path);
    }).then(this, [this, path](const Message& problem) {
        if (problem.empty())
            emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
        else
            fail(tr("The surface could not be exported."), problem);
    });
}

void FileFlow::exportPattern(const QImage& cover)
{
    auto* dialog = new ExportPatternDialog(m_session.document().design(), m_session.title(), m_window);
    connect(dialog, &ExportPatternDialog::placeWanted, this, &FileFlow::placeWanted);
    connect(dialog, &QDialog::accepted, this, [this, dialog, cover] {
        const PatternOrder order = dialog->order();
        const QString ending = patternEnding(order.format);
        chooseTarget(tr("Export pattern"),
                     proposed(ending, order.format == PatternFormat::SewingSheet ? tr("-sewing") : tr("-pattern")),
                     tr("%1 (*.%2)").arg(ending.toUpper(), ending), {ending},
                     [this, order, cover](const QString& path) { exportPatternTo(path, order, cover); });
    });
    openDialog(dialog);
}

void FileFlow::exportPatternTo(const QString& path, const PatternOrder& order, const QImage& cover)
{
    inBackground<Message>([design = m_session.document().design(), path, order, cover] {
        return replaceWholeFile(path, patternBytes(design, order, cover));
    }).then(this, [this, path](const Message& problem) {
        if (problem.empty())
            emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
        else
            fail(tr("The pattern could not be exported."), problem);
    });
}

namespace {

/// QImage does not tell when the disk is full.
Message writePng(const QImage& picture, const QString& path)
{
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG"))
        return {QT_TRANSLATE_NOOP("Message", "there is no picture to write"), {}};
    return replaceWholeFile(path, {png.constData(), static_cast<std::size_t>(png.size())});
}

} // namespace

void FileFlow::exportPicture(const QImage& picture)
{
    chooseTarget(tr("Export picture"), proposedPicture(), tr("PNG (*.png)"), {QStringLiteral("png")},
                 [this, picture](const QString& path) {
                     if (const Message problem = writePng(picture, path); problem.empty())
                         emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
                     else
                         fail(tr("The picture could not be exported."), problem);
                 });
}

} // namespace bolster
