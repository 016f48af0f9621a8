#include "DesignSession.h"

#include "Background.h"
#include "EditCodec.h"
#include "ElementEdits.h"
#include "Project.h"
#include "Samples.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace bolster {

namespace {

/// Not over what somebody else has made of the project meanwhile.
Message saveOurs(Journal& journal, const QString& file)
{
    if (QFileInfo::exists(file)) {
        const OpenedProject there = openProject(file);
        if (there.problem.empty() && journal.base() && there.seal != *journal.base())
            return {QT_TRANSLATE_NOOP("Message",
                                      "somebody else has changed it since it was opened here; save under "
                                      "another name, or open it to see the changes"),
                    {}};
    }
    return journal.save(file);
}

} // namespace

/// What was read in the background.
struct DesignSession::Opened {
    OpenedDesign design;
    WorkJournal::Taken journal; // of a project
};

DesignSession::DesignSession(QObject* parent)
    : QObject(parent)
    , m_journal(m_document)
{
    m_document.setRefusal(&refusal);
    connect(&m_document, &Document::changed, this, &DesignSession::designChanged);
    connect(&m_journal, &WorkJournal::failed, this, &DesignSession::recoveryFailed);
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
    take({{design.with(fabric), {}, {}, true}, {}}, {}, {}, {});
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

/// The current design of a project; its files are put into the folder.
DesignSession::Opened DesignSession::readProject(WorkJournal::Taken taken, const QString& files)
{
    Opened opened;
    if (!taken.journal) {
        opened.design.problems.push_back({{}, {}, {}, taken.project.problem});
        return opened;
    }
    const Design& design = taken.project.design;
    Problems lacking = extractAssets(taken.project, design, files);
    opened.design = openReadDesign({design, {}, true}, files);
    std::ranges::move(lacking, std::back_inserter(opened.design.problems));
    opened.journal = std::move(taken);
    opened.journal.files = files;
    return opened;
}

void DesignSession::open(const QString& path, Opening opening, const Replace& replace, const Done& done)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    const int generation = ++m_generation;
    const std::uint64_t revision = m_document.revision();
    inBackground<Opened>([file] {
        if (!looksLikeProject(file))
            return Opened{openDesign(file), {}};
        return readProject(WorkJournal::takeProject(file), DesignFolder::newOwnFolder());
    }).then(this, [this, file, opening, generation, revision, replace, done](const Opened& opened) {
        if (generation != m_generation)
            return; // something else was opened meanwhile
        if (!opened.design.readable) {
            done(opened.design.problems.empty()
                     ? Message{QT_TRANSLATE_NOOP("Message", "the file is not a design"), {}}
                     : opened.design.problems.front().message);
            return;
        }
        takeUnlessChanged(revision, replace, [this, file, opening, opened, done] {
            const QString& files = opened.journal.files;
            const bool look = opening == Opening::ToLook || isSample(file);
            take(opened, look ? QString() : file, files.isEmpty() ? QFileInfo(file).absolutePath() : files,
                 titleOf(file));
            done({});
        });
    });
}

void DesignSession::restore(const WorkJournal::Left& left, const Replace& replace, const Done& done)
{
    const std::uint64_t revision = m_document.revision();
    inBackground<Opened>([left] {
        return readProject(WorkJournal::takeLeft(left), left.place.files);
    }).then(this, [this, left, revision, replace, done](const Opened& opened) {
        if (!opened.design.readable) {
            done(opened.design.problems.front().message);
            return;
        }
        takeUnlessChanged(revision, replace, [this, left, opened, done] {
            const QString& original = left.place.original;
            take(opened, isSample(original) ? QString() : original, left.place.files, tr("Restored design"));
            done({});
        });
    });
}

void DesignSession::take(const Opened& opened, const QString& path, const QString& folder, const QString& title)
{
    ++m_generation;
    leaveWork();
    m_folder.start(folder);
    m_path = path;
    m_title = title;
    m_saving.reset();
    m_opened = opened.design.problems;
    m_known.clear();
    m_reading.clear();
    const Design& design = opened.design.design;
    const DesignFiles& files = opened.design.files;
    for (const auto& [id, element] : design.elements()) {
        const auto mesh = files.meshes.find(id);
        const auto cloud = files.clouds.find(id);
        if (mesh != files.meshes.end())
            m_known[keyOf(*element)] = {{mesh->second, nullptr}, {}};
        else if (cloud != files.clouds.end())
            m_known[keyOf(*element)] = {{nullptr, cloud->second}, {}};
    }
    for (const Problem& problem : m_opened)
        if (const ElementPtr element = design.element(problem.element);
            element && problem.field == "file" && elementFile(*element))
            m_known.try_emplace(keyOf(*element), ImportedFile{{}, problem.message});
    if (const OpenedProject& project = opened.journal.project; opened.journal.journal) {
        m_document.reset(design, project.history);
        m_document.markSaved(project.saved.value_or(0));
    } else {
        m_document.reset(design);
    }
    m_journal.start({path, folder}, opened.journal);
    updateFiles();
    emit titleChanged();
    emit problemsChanged();
    emit DesignSession::opened();
}

void DesignSession::save(const QString& path, const Done& done)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    m_saving = m_document.history().current();
    if (isProject(file))
        saveProject(file, done);
    else
        saveText(file, done);
}

void DesignSession::saveProject(const QString& file, const Done& done)
{
    addFiles([this, file, done](const Message& problem) {
        if (!problem.empty()) {
            endSaving(file, {}, problem, done);
            return;
        }
        const NodeId node = m_document.history().current();
        m_saving = node;
        const bool ours = file == m_path;
        withJournal([file, ours](Journal& journal) { return ours ? saveOurs(journal, file) : journal.save(file); },
                    [this, file, node, done](const Message& why) { endSaving(file, node, why, done); });
    });
}

void DesignSession::saveCopy(const QString& path, const SaveOptions& options, const Done& done)
{
    addFiles([this, path, options, done](const Message& problem) {
        if (problem.empty())
            withJournal([path, options](Journal& journal) { return journal.saveCopy(path, options); }, done);
        else
            done(problem);
    });
}

void DesignSession::endSaving(const QString& file, std::optional<NodeId> node, const Message& problem,
                              const Done& done)
{
    m_saving.reset();
    if (problem.empty()) {
        m_path = file;
        m_journal.move({file, m_folder.folder()});
        m_document.markSaved(*node);
        emit titleChanged();
    }
    done(problem);
    emit saveEnded();
}

/// Gives the journal to `work` beside the GUI thread; edits wait meanwhile. `done` is not called when another
/// design was opened.
void DesignSession::withJournal(const std::function<Message(Journal&)>& work, const Done& done)
{
    m_journal.suspend();
    const int generation = m_generation;
    inBackground<Message>([journal = m_journal.journal(), work] {
        return work(*journal);
    }).then(this, [this, generation, done](const Message& problem) {
        if (generation != m_generation)
            return;
        m_journal.resume();
        done(problem);
    });
}

/// The files that the design uses become part of the project.
void DesignSession::addFiles(const Done& done)
{
    if (const Message problem = m_journal.prepare(); !problem.empty()) {
        done(problem);
        return;
    }
    std::map<std::string, QString> files;
    for (const auto& [key, imported] : m_known)
        if (const QString file = m_folder.find(key.second); !file.isEmpty())
            files[key.second.toStdString()] = file;
    auto names = std::make_shared<std::map<std::string, std::string>>(); // as the project has them
    withJournal(
        [files, names](Journal& journal) {
            for (const auto& [name, file] : files) {
                std::string kept = name;
                if (Message problem = journal.addAsset(kept, file); !problem.empty())
                    return problem;
                (*names)[name] = kept;
            }
            return Message();
        },
        [this, names, done](const Message& problem) {
            if (problem.empty())
                renameFiles(*names);
            done(problem);
        });
}

/// Where an older version of the design means another file by the same name.
void DesignSession::renameFiles(const std::map<std::string, std::string>& names)
{
    Design renamed = m_document.committed();
    for (const auto& [id, element] : m_document.committed().elements()) {
        const std::string* file = elementFile(*element);
        const auto name = file ? names.find(*file) : names.end();
        if (name == names.end() || name->second == name->first)
            continue;
        const QString to = QString::fromStdString(name->second);
        QFile::copy(m_folder.find(QString::fromStdString(name->first)), QDir(m_folder.folder()).filePath(to));
        const ElementPtr next = withFile(*element, name->second);
        m_known[keyOf(*next)] = m_known[keyOf(*element)];
        renamed = renamed.with(edits::replaceElement(renamed, id, next, {}));
    }
    m_document.commit(
        editBetween(m_document.committed(), renamed, {QT_TRANSLATE_NOOP("Message", "Rename a file"), {}}));
}

void DesignSession::saveText(const QString& file, const Done& done)
{
    const QString folder = QFileInfo(file).absolutePath();
    Design arranged;
    if (const Message problem = m_folder.copyTo(folder, m_document.committed(), &arranged); !problem.empty()) {
        endSaving(file, {}, problem, done);
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
        if (generation != m_generation)
            return;
        if (problem.empty())
            m_journal.savedAsText(node);
        endSaving(file, node, problem, done);
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

void DesignSession::end()
{
    leaveWork();
    m_folder.start({});
}

/// Whatever becomes of unsaved work, its files must be there as long.
void DesignSession::leaveWork()
{
    if (m_document.dirty())
        m_folder.leave();
    m_journal.end();
}

Message DesignSession::addWithFile(const QString& source, FileContent content, const Element& element,
                                   std::optional<ElementId> replaced)
{
    m_document.cancelGesture();
    if (m_path.isEmpty() && !m_folder.ownFolder()) {
        if (Message problem = m_folder.makeOwnFolder(m_document.design()); !problem.empty())
            return problem;
        m_journal.move({{}, m_folder.folder()});
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
