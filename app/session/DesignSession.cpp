#include "DesignSession.h"

#include "Background.h"
#include "EditCodec.h"
#include "ElementEdits.h"

#include <QFileInfo>

#include <algorithm>

namespace bolster {

DesignSession::DesignSession(QObject* parent)
    : QObject(parent)
    , m_journal(m_document)
{
    m_document.setRefusal(&refusal);
    connect(&m_document, &Document::changed, this, &DesignSession::designChanged);
    connect(&m_journal, &WorkJournal::failed, this, &DesignSession::recoveryFailed);
    connect(&m_journal, &WorkJournal::worksAgain, this, &DesignSession::recoveryWorksAgain);
}

DesignSession::~DesignSession()
{
    m_opening.request_stop();
}

QString DesignSession::title() const
{
    if (!m_path.isEmpty())
        return QFileInfo(m_path).fileName();
    return m_title.isEmpty() ? tr("New design") : m_title;
}

bool DesignSession::readOnly() const
{
    const QFileInfo file(m_path);
    if (m_path.isEmpty() || !file.exists())
        return m_path.isEmpty() && m_onlyToLook;
    return !file.isWritable() || !QFileInfo(file.absolutePath()).isWritable();
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
    emit leaving();
    if (m_document.hasUnsavedWork())
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
        m_journal.move({{}, m_folder.folder(), {}, m_title});
    }
    QString name;
    const auto taken = [journal = m_journal.journal()](const QString& free) {
        return journal && journal->hasAsset(free.toStdString());
    };
    if (Message problem = m_folder.add(source, &name, taken); !problem.empty())
        return problem;
    ElementPtr added = withFile(element, name.toStdString());
    if (!replaced)
        added = edits::withFreeName(m_document.design(), *added);
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
        m_journal.journal(),
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
                const ImportedFile& file = known->second;
                if (!file.content)
                    found.push_back({id, elementLabel(id, *element), "file", file.problem});
                else if (!file.warning.empty())
                    found.push_back({id, elementLabel(id, *element), "file", file.warning, Severity::Warning});
            }
    }
    return found;
}

} // namespace bolster
