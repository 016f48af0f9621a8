#include "DesignSession.h"

#include "Background.h"
#include "ElementEdits.h"
#include "MeshImport.h"
#include "Samples.h"

#include <QFileInfo>

#include <algorithm>

namespace bolster {

DesignSession::DesignSession(QObject* parent)
    : QObject(parent)
    , m_recovery(m_document)
{
    connect(&m_document, &Document::changed, this, &DesignSession::designChanged);
    connect(&m_recovery, &Recovery::failed, this, &DesignSession::recoveryFailed);
}

DesignSession::~DesignSession() = default;

QString DesignSession::title() const
{
    if (!m_path.isEmpty())
        return QFileInfo(m_path).fileName();
    return m_title.isEmpty() ? tr("New design") : m_title;
}

void DesignSession::startNew()
{
    Design design;
    const Edit fabric = edits::addElement(design, makeElement(Fabric{tr("Fabric").toStdString()}));
    take({design.with(fabric), {}, {}, true}, {}, {}, {});
}

/// The design may have been changed while another one was read.
void DesignSession::takeUnlessChanged(std::uint64_t revision, const Replace& replace,
                                      const std::function<void()>& take)
{
    if (m_document.revision() == revision)
        take();
    else
        replace(take);
}

void DesignSession::open(const QString& path, const Replace& replace, const Done& done)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    const int generation = ++m_generation;
    const std::uint64_t revision = m_document.revision();
    inBackground<OpenedDesign>([file] {
        return openDesign(file);
    }).then(this, [this, file, generation, revision, replace, done](const OpenedDesign& opened) {
        if (generation != m_generation)
            return; // something else was opened meanwhile
        if (!opened.readable) {
            done(opened.problems.empty() ? Message{QT_TRANSLATE_NOOP("Message", "the file is not a design"), {}}
                                         : opened.problems.front().message);
            return;
        }
        takeUnlessChanged(revision, replace, [this, file, opened, done] {
            take(opened, isSample(file) ? QString() : file, QFileInfo(file).absolutePath(), titleOf(file));
            done({});
        });
    });
}

void DesignSession::restore(const Recovery::Orphan& orphan, const Replace& replace, const Done& done)
{
    const std::uint64_t revision = m_document.revision();
    inBackground<OpenedDesign>([orphan] {
        return openDesign(orphan.file, orphan.frameFolder());
    }).then(this, [this, orphan, revision, replace, done](const OpenedDesign& opened) {
        if (!opened.readable) {
            done({QT_TRANSLATE_NOOP("Message", "the copy could not be read"), {}});
            return;
        }
        takeUnlessChanged(revision, replace, [this, orphan, opened, done] {
            const QString folder = orphan.frameFolder();
            const bool hasFile = !orphan.original.isEmpty() && !FrameFiles::isOwnFolder(folder) &&
                                 !isSample(orphan.original) && !orphan.fileIsNewer();
            take(opened, hasFile ? orphan.original : QString(), folder, tr("Restored design"));
            m_document.markUnsaved();
            m_recovery.adopt(orphan);
            done({});
        });
    });
}

void DesignSession::discard(const Recovery::Orphan& orphan)
{
    Recovery::discard(orphan);
    FrameFiles leftOver;
    leftOver.moved(orphan.frameFolder());
    leftOver.start({});
}

void DesignSession::take(OpenedDesign opened, const QString& path, const QString& folder, const QString& title)
{
    ++m_generation;
    m_recovery.discard();
    m_files.start(folder);
    m_recovery.setOriginal(path.isEmpty() && !folder.isEmpty() ? folder + QStringLiteral("/untitled.json") : path);
    m_path = path;
    m_title = title;
    m_workDiscarded = false;
    m_saving.reset();
    m_opened = std::move(opened.problems);
    m_meshes.clear();
    m_meshProblems.clear();
    m_reading.clear();
    opened.design.each<Frame>([&](ElementId id, const Frame& frame) {
        const QString file = QString::fromStdString(frame.file);
        if (const auto mesh = opened.frames.find(id); mesh != opened.frames.end())
            m_meshes[file] = mesh->second;
    });
    for (const Problem& problem : m_opened)
        if (const Frame* frame = opened.design.find<Frame>(problem.element); frame && problem.field == "file") {
            m_meshes.try_emplace(QString::fromStdString(frame->file), nullptr);
            m_meshProblems[QString::fromStdString(frame->file)] = problem.message;
        }
    m_document.reset(std::move(opened.design));
    updateFrames();
    emit titleChanged();
    emit problemsChanged();
    emit DesignSession::opened();
}

void DesignSession::save(const QString& path, const Done& done)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    const QString folder = QFileInfo(file).absolutePath();
    Design arranged;
    if (const Message problem = m_files.copyTo(folder, m_document.committed(), &arranged); !problem.empty()) {
        done(problem);
        return;
    }
    // A frame that had to take another name beside the design: the renamed one is what is saved and shown.
    m_files.moved(folder);
    if (const Edit renamed = editBetween(m_document.committed(), arranged,
                                         {QT_TRANSLATE_NOOP("Message", "Rename the frame's file"), {}});
        !renamed.empty())
        m_document.commit(renamed);
    const NodeId node = m_document.history().current();
    const int generation = m_generation;
    m_saving = node;
    inBackground<Message>([file, design = m_document.committed()] {
        return saveDesign(design, file);
    }).then(this, [this, file, node, generation, done](const Message& problem) {
        if (m_saving == node)
            m_saving.reset();
        if (problem.empty() && generation == m_generation) {
            m_path = file;
            m_recovery.setOriginal(file);
            m_document.markSaved(node);
            emit titleChanged();
        }
        done(problem);
        emit saveEnded();
    });
}

bool DesignSession::isElementFile(const QString& path) const
{
    const QString target = QFileInfo(path).canonicalFilePath();
    if (target.isEmpty())
        return false;
    return std::ranges::any_of(m_document.design().elements(), [&](const auto& item) {
        const std::string* file = elementFile(*item.second);
        return file && QFileInfo(m_files.find(QString::fromStdString(*file))).canonicalFilePath() == target;
    });
}

void DesignSession::discardWork()
{
    m_recovery.discard();
    m_workDiscarded = true;
}

void DesignSession::end()
{
    if (!m_document.dirty() || m_workDiscarded)
        m_files.start({});
}

Message DesignSession::addFrame(const QString& source, std::shared_ptr<const TriangleMesh> mesh, Frame frame,
                                std::optional<ElementId> replaced)
{
    m_document.cancelGesture();
    if (m_path.isEmpty() && !m_files.ownFolder()) {
        if (Message problem = m_files.makeOwnFolder(m_document.design()); !problem.empty())
            return problem;
        m_recovery.setOriginal(m_files.folder() + QStringLiteral("/untitled.json"));
    }
    QString name;
    if (Message problem = m_files.add(source, &name); !problem.empty())
        return problem;
    m_meshes[name] = std::move(mesh);
    m_meshProblems.erase(name);
    frame.file = name.toStdString();
    const Design& design = m_document.design();
    if (replaced && design.find<Frame>(*replaced)) {
        frame.name = design.find<Frame>(*replaced)->name;
        m_document.commit(
            edits::replaceElement(design, *replaced, makeElement(frame),
                                  {QT_TRANSLATE_NOOP("Message", "Change the mesh of %1"), {frame.name}}));
    } else {
        const ElementId id = design.nextId();
        m_document.commit(edits::addElement(design, makeElement(std::move(frame))));
        emit frameImported(id);
    }
    return {};
}

void DesignSession::designChanged(const std::set<ElementId>& ids)
{
    const auto concernsFrames = [this](ElementId id) {
        return m_frames.contains(id) || m_document.design().find<Frame>(id);
    };
    if (std::ranges::any_of(ids, concernsFrames))
        updateFrames();
}

void DesignSession::updateFrames()
{
    FrameMeshes frames;
    m_document.design().each<Frame>([&](ElementId id, const Frame& frame) {
        const QString file = QString::fromStdString(frame.file);
        const auto known = m_meshes.find(file);
        if (known == m_meshes.end())
            readMissing(file);
        else if (known->second)
            frames.emplace(id, known->second);
    });
    if (frames != m_frames) {
        m_frames = std::move(frames);
        emit framesChanged();
    }
}

void DesignSession::readMissing(const QString& file)
{
    if (m_reading.contains(file))
        return;
    m_reading.insert(file);
    const QString path = m_files.find(file);
    const int generation = m_generation;
    inBackground<ImportedMesh>([path] {
        return path.isEmpty()
                   ? ImportedMesh{nullptr, {QT_TRANSLATE_NOOP("Message", "the frame's file is missing"), {}}}
                   : importMesh(path);
    }).then(this, [this, file, generation](const ImportedMesh& imported) {
        if (generation != m_generation)
            return;
        m_reading.remove(file);
        m_meshes[file] = imported.mesh;
        if (!imported.mesh)
            m_meshProblems[file] = imported.problem;
        updateFrames();
        emit problemsChanged();
    });
}

Problems DesignSession::problems() const
{
    Problems found;
    const Design& design = m_document.design();
    for (const auto& [id, element] : design.elements()) {
        if (const auto* bad = std::get_if<Quarantined>(element.get()))
            found.insert(found.end(), bad->problems.begin(), bad->problems.end());
        if (const auto* frame = std::get_if<Frame>(element.get()))
            if (const auto why = m_meshProblems.find(QString::fromStdString(frame->file));
                why != m_meshProblems.end())
                found.push_back({id, elementLabel(id, *element), "file", why->second});
    }
    return found;
}

} // namespace bolster
