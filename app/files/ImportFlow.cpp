#include "ImportFlow.h"

#include "FileFormats.h"
#include "FileImportDialog.h"
#include "FixationsLeft.h"
#include "FrameSimplifying.h"
#include "ImportPatternDialog.h"
#include "PatternImport.h"
#include "Translated.h"
#include "WithProgress.h"

#include <QFileInfo>

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

const QString frameKind = QStringLiteral("frame"), scanKind = QStringLiteral("scan"); // of folders

QString meshFilter()
{
    return ImportFlow::tr("Frames (%1)").arg(patternsOf(FileUse::Frame));
}

QString scanFilter()
{
    return ImportFlow::tr("Scans (%1)").arg(patternsOf(FileUse::Scan));
}

} // namespace

ImportFlow::ImportFlow(DesignSession& session, FileTalk& talk)
    : m_session(session)
    , m_talk(talk)
{}

void ImportFlow::importFrame(const QString& path)
{
    import(Frame{}, tr("Import frame"), meshFilter(), path);
}

void ImportFlow::importScan(const QString& path)
{
    Scan scan;
    scan.enabled = false; // until it is aligned the cover would be pulled to the wrong place
    import(scan, tr("Import scan"), scanFilter(), path);
}

void ImportFlow::importPattern(const QString& path)
{
    if (path.isEmpty()) {
        m_talk.askForImport(QStringLiteral("pattern"), tr("Import pattern"),
                            tr("Patterns (%1)").arg(patternsOf(FileUse::Pattern)),
                            [this](const QString& file) { importPattern(file); });
        return;
    }
    withProgress<ImportedDrawing>(
        this, m_talk.window(), m_talk.readingText(path),
        [path](const ImportWatch& watch) { return importDrawing(path, watch); },
        [this, path](const ImportedDrawing& imported) {
            if (imported.drawing)
                choosePieces(path, *imported.drawing);
            else if (!imported.problem.empty())
                failImport(path, imported.problem);
        });
}

void ImportFlow::replaceFile(ElementId id)
{
    const ElementPtr element = m_session.document().design().element(id);
    if (!element || !elementPlacement(*element))
        return;
    const bool isFrame = fileKind(*element) == FileKind::Mesh;
    m_talk.askForImport(isFrame ? frameKind : scanKind, tr("Choose another file"),
                        isFrame ? meshFilter() : scanFilter(),
                        [this, element, id](const QString& file) { importNow(file, *element, id); });
}

/// A new element like `element`, named after its file.
template <class T>
void ImportFlow::import(const T& element, const QString& title, const QString& filter, const QString& path)
{
    const auto take = [this, element](const QString& file) {
        T named = element;
        named.name = QFileInfo(file).completeBaseName().toStdString();
        importNow(file, std::move(named), {});
    };
    if (path.isEmpty())
        m_talk.askForImport(fileKind(element) == FileKind::Mesh ? frameKind : scanKind, title, filter, take);
    else
        take(path);
}

void ImportFlow::importNow(const QString& path, const Element& element, std::optional<ElementId> replaced)
{
    withProgress<ImportedFile>(
        this, m_talk.window(), m_talk.readingText(path),
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

void ImportFlow::choosePieces(const QString& path, const Drawing& drawing)
{
    auto* dialog = new ImportPatternDialog(drawing, path, m_talk.window());
    connect(dialog, &QDialog::accepted, this, [this, path, dialog] {
        if (const auto pattern = dialog->pattern())
            addPattern(path, pattern, dialog->choice());
    });
    openDialog(dialog);
}

/// Curves are fitted in the background, to the design as it is then: an edit that comes in between is kept.
void ImportFlow::addPattern(const QString& path, const std::shared_ptr<const FoundPattern>& pattern,
                            const PatternChoice& choice)
{
    const Design design = m_session.document().design();
    withProgress<ImportedPattern>(
        this, m_talk.window(), m_talk.readingText(path),
        [design, pattern, choice](const ImportWatch&) { return patternEdit(design, *pattern, choice); },
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
                tell(m_talk.window(), QMessageBox::Information,
                     tr("The pattern is imported. What is otherwise than in the file:"),
                     notes.mid(0, 12).join(u'\n'));
        });
}

void ImportFlow::place(const QString& path, const ImportedFile& file, const Element& element,
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
    auto* dialog = new FileImportDialog(path, file.content, before, file.said, m_talk.window());
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

void ImportFlow::writeAnew(const PlacedFile& file, const std::vector<std::string>& unwanted,
                           std::optional<std::size_t> triangles)
{
    const QString title = triangles ? tr("Simplifying %1 \u2026") : tr("Writing %1 \u2026");
    withProgress<SimplifiedFrame>(
        this, m_talk.window(), title.arg(QFileInfo(file.path).fileName()),
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

void ImportFlow::addPlaced(const PlacedFile& file)
{
    if (const Message problem = m_session.addWithFile(file.path, file.content, file.element, file.replaced);
        !problem.empty()) {
        failImport(file.path, problem);
        return;
    }
    emit imported(fileKind(file.element));
    if (file.replaced && file.content.mesh)
        tellFixationsOff(m_talk.window(), m_session.document().design(), file.old,
                         {file.content.mesh, *elementPlacement(file.element)});
}

void ImportFlow::failImport(const QString& path, const Message& why)
{
    m_talk.fail(tr("\"%1\" could not be imported.").arg(QFileInfo(path).fileName()), why);
}

} // namespace bolster
