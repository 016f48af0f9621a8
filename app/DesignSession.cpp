#include "DesignSession.h"

#include "Background.h"
#include "ElementEdits.h"
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
            const bool hasFile = !orphan.original.isEmpty() && !DesignFolder::isOwnFolder(folder) &&
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
    DesignFolder leftOver;
    leftOver.moved(orphan.frameFolder());
    leftOver.start({});
}

void DesignSession::take(OpenedDesign opened, const QString& path, const QString& folder, const QString& title)
{
    ++m_generation;
    m_recovery.discard();
    m_folder.start(folder);
    m_recovery.setOriginal(path.isEmpty() && !folder.isEmpty() ? folder + QStringLiteral("/untitled.json") : path);
    m_path = path;
    m_title = title;
    m_workDiscarded = false;
    m_saving.reset();
    m_opened = std::move(opened.problems);
    m_known.clear();
    m_reading.clear();
    for (const auto& [id, element] : opened.design.elements()) {
        const auto mesh = opened.files.meshes.find(id);
        const auto cloud = opened.files.clouds.find(id);
        if (mesh != opened.files.meshes.end())
            m_known[keyOf(*element)] = {{mesh->second, nullptr}, {}};
        else if (cloud != opened.files.clouds.end())
            m_known[keyOf(*element)] = {{nullptr, cloud->second}, {}};
    }
    for (const Problem& problem : m_opened)
        if (const ElementPtr element = opened.design.element(problem.element);
            element && problem.field == "file" && elementFile(*element))
            m_known.try_emplace(keyOf(*element), ImportedFile{{}, problem.message});
    m_document.reset(std::move(opened.design));
    updateFiles();
    emit titleChanged();
    emit problemsChanged();
    emit DesignSession::opened();
}

void DesignSession::save(const QString& path, const Done& done)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    const QString folder = QFileInfo(file).absolutePath();
    Design arranged;
    if (const Message problem = m_folder.copyTo(folder, m_document.committed(), &arranged); !problem.empty()) {
        done(problem);
        return;
    }
    // A file that had to take another name beside the design: the renamed one is what is saved and shown.
    m_folder.moved(folder);
    if (const Edit renamed =
            editBetween(m_document.committed(), arranged, {QT_TRANSLATE_NOOP("Message", "Rename a file"), {}});
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
        return file && QFileInfo(m_folder.find(QString::fromStdString(*file))).canonicalFilePath() == target;
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
        m_folder.start({});
}

Message DesignSession::addWithFile(const QString& source, FileContent content, const Element& element,
                                   std::optional<ElementId> replaced)
{
    m_document.cancelGesture();
    if (m_path.isEmpty() && !m_folder.ownFolder()) {
        if (Message problem = m_folder.makeOwnFolder(m_document.design()); !problem.empty())
            return problem;
        m_recovery.setOriginal(m_folder.folder() + QStringLiteral("/untitled.json"));
    }
    QString name;
    if (Message problem = m_folder.add(source, &name); !problem.empty())
        return problem;
    const ElementPtr added = withFile(element, name.toStdString());
    m_known[keyOf(*added)] = {std::move(content), {}};
    const Design& design = m_document.design();
    if (replaced && design.element(*replaced)) {
        m_document.commit(
            edits::replaceElement(design, *replaced, added,
                                  {QT_TRANSLATE_NOOP("Message", "Change the file of %1"), {elementName(*added)}}));
    } else {
        const ElementId id = design.nextId();
        m_document.commit(edits::addElement(design, added));
        emit imported(id);
    }
    return {};
}

DesignSession::FileKey DesignSession::keyOf(const Element& element)
{
    return {fileKind(element), QString::fromStdString(*elementFile(element))};
}

void DesignSession::designChanged(const std::set<ElementId>& ids)
{
    const auto concernsFiles = [this](ElementId id) {
        const ElementPtr element = m_document.design().element(id);
        return m_files.meshes.contains(id) || m_files.clouds.contains(id) || (element && elementFile(*element));
    };
    if (std::ranges::any_of(ids, concernsFiles))
        updateFiles();
}

void DesignSession::updateFiles()
{
    DesignFiles files;
    for (const auto& [id, element] : m_document.design().elements()) {
        if (!elementFile(*element))
            continue;
        const FileKey key = keyOf(*element);
        if (const auto known = m_known.find(key); known != m_known.end())
            known->second.content.addTo(files, id);
        else
            readMissing(key);
    }
    if (files != m_files) {
        m_files = std::move(files);
        emit filesChanged();
    }
}

void DesignSession::readMissing(const FileKey& key)
{
    if (!m_reading.insert(key).second)
        return;
    const QString path = m_folder.find(key.second);
    const int generation = m_generation;
    inBackground<ImportedFile>([kind = key.first, path] {
        return path.isEmpty() ? ImportedFile{{}, {QT_TRANSLATE_NOOP("Message", "the file is missing"), {}}}
                              : importFile(kind, path);
    }).then(this, [this, key, generation](const ImportedFile& imported) {
        if (generation != m_generation)
            return;
        m_reading.erase(key);
        m_known[key] = imported;
        updateFiles();
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
        if (elementFile(*element))
            if (const auto known = m_known.find(keyOf(*element)); known != m_known.end() && !known->second.content)
                found.push_back({id, elementLabel(id, *element), "file", known->second.problem});
    }
    return found;
}

} // namespace bolster
