#include "DesignSession.h"

#include "Background.h"
#include "EditCodec.h"
#include "ElementEdits.h"
#include "Project.h"
#include "Samples.h"

#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace bolster {

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
    m_names.clear();
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
            element && problem.field == "file" && hasShapeFile(*element))
            if (ImportedFile& file =
                    m_known.try_emplace(keyOf(*element), ImportedFile{{}, problem.message}).first->second;
                file.content)
                file.warning = problem.message;
    if (const OpenedProject& project = opened.journal.project; opened.journal.journal) {
        m_document.reset(design, project.history);
        m_document.markSaved(project.saved.value_or(0));
    } else {
        m_document.reset(design);
    }
    m_journal.start({path, folder}, opened.journal);
    for (const auto& [id, element] : design.elements())
        noteFile(*element);
    updateFiles();
    emit titleChanged();
    emit problemsChanged();
    emit DesignSession::opened();
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
    const auto taken = [journal = m_journal.journal()](const QString& free) {
        return journal && journal->hasAsset(free.toStdString());
    };
    if (Message problem = m_folder.add(source, &name, taken); !problem.empty())
        return problem;
    const ElementPtr added = withFile(element, name.toStdString());
    if (hasShapeFile(*added))
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
    for (const ElementId id : ids)
        if (const ElementPtr element = m_document.design().element(id))
            noteFile(*element);
    const auto concernsFiles = [this](ElementId id) {
        const ElementPtr element = m_document.design().element(id);
        return m_files.meshes.contains(id) || m_files.clouds.contains(id) || (element && hasShapeFile(*element));
    };
    if (std::ranges::any_of(ids, concernsFiles))
        updateFiles();
}

/// All of them belong to the project. A picture that only an older version has is brought from there; whoever shows
/// it reads it. Meshes and scans are read here: readMissing.
void DesignSession::noteFile(const Element& element)
{
    const std::string* file = elementFile(element);
    if (!file || !m_names.insert(QString::fromStdString(*file)).second || hasShapeFile(element) ||
        !m_journal.journal() || !m_folder.ownFolder() || !m_folder.find(QString::fromStdString(*file)).isEmpty())
        return;
    besideEdits(
        [name = *file, folder = m_folder.folder()](Journal& journal) { return journal.extractAsset(name, folder); },
        [this](const Message& problem) {
            if (problem.empty())
                emit filesChanged();
        });
}

DesignFiles DesignSession::filesOf(const Design& design)
{
    DesignFiles files;
    for (const auto& [id, element] : design.elements()) {
        if (!hasShapeFile(*element))
            continue;
        const FileKey key = keyOf(*element);
        if (const auto known = m_known.find(key); known != m_known.end())
            known->second.content.addTo(files, id);
        else
            readMissing(key);
    }
    return files;
}

void DesignSession::updateFiles()
{
    DesignFiles files = filesOf(m_document.design());
    if (files != m_files) {
        m_files = std::move(files);
        emit filesChanged();
    }
}

void DesignSession::readMissing(const FileKey& key)
{
    if (!m_reading.insert(key).second)
        return;
    const int generation = m_generation;
    inBackground<ImportedFile>([key, folder = m_folder, journal = m_journal.journal()] {
        return readFile(key, folder, journal.get());
    }).then(this, [this, key, generation](const ImportedFile& imported) {
        // What was read before this could be said is told at once: before whoever asked has gone on.
        QMetaObject::invokeMethod(
            this, [this, key, generation, imported] { takeRead(key, generation, imported); }, Qt::QueuedConnection);
    });
}

void DesignSession::takeRead(const FileKey& key, int generation, const ImportedFile& imported)
{
    if (generation != m_generation)
        return;
    m_reading.erase(key);
    m_known[key] = imported;
    updateFiles();
    emit fileRead();
    emit problemsChanged();
}

/// Older versions mean files that nobody has asked the project for yet.
ImportedFile DesignSession::readFile(const FileKey& key, const DesignFolder& folder, Journal* journal)
{
    const auto& [kind, name] = key;
    if (const QString path = folder.find(name); !path.isEmpty())
        return importFile(kind, path);
    if (!journal || !folder.ownFolder())
        return {{}, {QT_TRANSLATE_NOOP("Message", "the file is missing"), {}}};
    if (Message problem = journal->extractAsset(name.toStdString(), folder.folder()); !problem.empty())
        return {{}, std::move(problem)};
    return importFile(kind, folder.find(name));
}

Problems DesignSession::problems() const
{
    Problems found;
    const Design& design = m_document.design();
    for (const auto& [id, element] : design.elements()) {
        if (const auto* bad = std::get_if<Quarantined>(element.get()))
            found.insert(found.end(), bad->problems.begin(), bad->problems.end());
        if (hasShapeFile(*element))
            if (const auto known = m_known.find(keyOf(*element)); known != m_known.end()) {
                const auto& [content, problem, warning] = known->second;
                if (!content)
                    found.push_back({id, elementLabel(id, *element), "file", problem});
                else if (!warning.empty())
                    found.push_back({id, elementLabel(id, *element), "file", warning, Severity::Warning});
            }
    }
    return found;
}

} // namespace bolster
