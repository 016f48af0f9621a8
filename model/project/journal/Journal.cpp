#include "Journal.h"

#include "BlobStore.h"
#include "DiskFile.h"
#include "JournalLog.h"
#include "JournalStep.h"
#include "ProjectContents.h"
#include "ProjectRows.h"
#include "Schema.h"
#include "TemporaryFile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace bolster {
namespace {

constexpr int editsPerSnapshot = 1000;

/// Durable: each transaction is on the disk before it ends.
void prepareForWork(Database& database)
{
    database.run("PRAGMA page_size = 8192");
    database.run("PRAGMA locking_mode = EXCLUSIVE"); // before the first access: then there is no shared memory
    database.run("PRAGMA synchronous = EXTRA"); // as FULL, and the journal of a new file stays gone when it is gone
    database.run("PRAGMA journal_mode = WAL");
    Transaction lock(database); // whoever else has the file open is noticed now
    lock.commit();
}

Journal::Opened failed(Message why)
{
    Journal::Opened result;
    result.project.problem = std::move(why);
    return result;
}

Journal::Opened failed(const QString& path, const char* sentence)
{
    return failed(Message{sentence, {path.toStdString()}});
}

std::shared_ptr<Journal::Identity> newIdentity()
{
    return std::make_shared<Journal::Identity>(Journal::Identity{newUid(), {}});
}

template <class Work>
Journal::Opened guardedOpen(Work work)
{
    try {
        return work();
    } catch (const DatabaseError& error) {
        return failed(error.message);
    } catch (const std::bad_alloc&) {
        return failed({QT_TRANSLATE_NOOP("Message", "there is not enough memory for this project"), {}});
    }
}

/// Grows by more than is asked for: an edit must not cost what all before it do.
template <class T>
void makeRoom(std::vector<T>& list, std::size_t more)
{
    if (list.capacity() < list.size() + more)
        list.reserve(std::max(list.size() + more, 2 * list.capacity()));
}

/// The content that goes by this name.
std::optional<std::int64_t> assetNumber(Database& database, const std::string& name)
{
    Query asset(database, "SELECT blob FROM asset WHERE name = ?", {Value::text(name)});
    return asset.next() ? std::optional(asset.integer(0)) : std::nullopt;
}

/// "frames/chair.obj" becomes "frames/chair-2.obj".
std::string numbered(const std::string& name, int number)
{
    const std::size_t slash = name.find_last_of('/');
    const std::size_t dot = name.find_last_of('.');
    const std::size_t end =
        dot == std::string::npos || (slash != std::string::npos && dot < slash) ? name.size() : dot;
    return name.substr(0, end) + "-" + std::to_string(number) + name.substr(end);
}

} // namespace

Journal::Journal(std::shared_ptr<Database> database, std::shared_ptr<Identity> identity)
    : m_database(std::move(database))
    , m_identity(std::move(identity))
{}

/// Histories may live longer: they must not keep the file from being opened again.
Journal::~Journal()
{
    m_database->close();
}

Journal::Opened Journal::create(const QString& path, const Design& design, const char* vfs, std::int64_t began)
{
    if (!vfs && QFileInfo::exists(path))
        return failed(path, QT_TRANSLATE_NOOP("Message", "there is a file \"%1\" already"));
    if (Message problem = refusal(editBetween(Design(), design, {})); !problem.empty())
        return failed(std::move(problem));
    return guardedOpen([&] {
        auto database = std::make_shared<Database>(path, Database::Access::Working, vfs);
        prepareForWork(*database);
        auto identity = newIdentity();
        identity->began = began;
        return createIn(std::move(database), design, std::move(identity));
    });
}

Journal::Opened Journal::create(const QString& path, const Design& design, std::shared_ptr<Identity> identity)
{
    if (QFileInfo::exists(path))
        return failed(path, QT_TRANSLATE_NOOP("Message", "there is a file \"%1\" already"));
    return guardedOpen([&] {
        auto database = std::make_shared<Database>(path, Database::Access::Working);
        prepareForWork(*database);
        return createIn(std::move(database), design, std::move(identity));
    });
}

Journal::Opened Journal::createStandIn(const QString& path, const Design& design,
                                       std::shared_ptr<Identity> identity)
{
    return guardedOpen([&] {
        auto database = std::make_shared<Database>(path, Database::Access::Working);
        prepareUnshared(*database);
        return createIn(std::move(database), design, std::move(identity));
    });
}

Journal::Opened Journal::createIn(std::shared_ptr<Database> database, const Design& design,
                                  std::shared_ptr<Identity> identity)
{
    Transaction transaction(*database);
    SealedRows rows(*database, {});
    createTables(*database);
    putProject(rows, identity->uuid, std::nullopt);
    NewNode first = firstNode(design);
    first.uid = identity->uids.try_emplace(0, first.uid).first->second;
    if (identity->began > 0)
        first.at = identity->began;
    putNode(rows, first, {});
    putSnapshot(rows, 0, design); // a second copy: all other versions begin with it
    rows.close(0);
    transaction.commit();
    return opened(database, std::move(identity)); // the transaction needs it until it has ended
}

Journal::Opened Journal::standIn(const QString& path)
{
    return copyTo(path, prepareUnshared);
}

Journal::Opened Journal::successor(const QString& path)
{
    return copyTo(path, prepareForWork);
}

Journal::Opened Journal::copyTo(const QString& path, void (*prepare)(Database&))
{
    return guardedOpen([&] {
        const std::scoped_lock turn(*m_database);
        m_database->vacuumInto(path);
        auto database = std::make_shared<Database>(path, Database::Access::Working);
        prepare(*database);
        Opened result = opened(std::move(database), m_identity);
        result.journal->m_base = m_base;
        result.journal->m_run = m_run;
        result.journal->m_behind = true;
        return result;
    });
}

Journal::Opened Journal::begin(const QString& project, const QString& path)
{
    if (QFileInfo::exists(path))
        return failed(path, QT_TRANSLATE_NOOP("Message", "there is a file \"%1\" already"));
    OpenedProject checked = openProject(project);
    if (!checked.problem.empty())
        return failed(std::move(checked.problem));
    removeLeftTemporaryFiles(QFileInfo(project).absolutePath());
    TemporaryFile copy(path);
    if (Message problem = copy.copyFrom(project); !problem.empty())
        return failed(std::move(problem));
    QFile::setPermissions(copy.path(), QFile::ReadOwner | QFile::WriteOwner);
    if (Message problem = copy.moveIntoPlace(); !problem.empty())
        return failed(std::move(problem));
    Opened result = open(path);
    if (result.journal) {
        result.journal->m_base = checked.seal;
        if (Message problem = result.journal->guarded([&] {
                Step step(*result.journal->m_database, result.journal->m_seal);
                putProject(step.rows, result.journal->uuid(), checked.seal);
                result.journal->accept(step, result.journal->m_current);
            });
            !problem.empty())
            return failed(std::move(problem));
        result.project.base = checked.seal;
    }
    return result;
}

Journal::Opened Journal::open(const QString& path, const char* vfs)
{
    if (!vfs && !QFileInfo(path).isFile())
        return failed(path, QT_TRANSLATE_NOOP("Message", "there is no file \"%1\""));
    if (!vfs && logBreaksOff(path + "-wal"))
        return failed(path,
                      QT_TRANSLATE_NOOP("Message", "the log of \"%1\" is damaged: the last edits cannot be read"));
    return guardedOpen([&] {
        auto database = std::make_shared<Database>(path, Database::Access::Working, vfs);
        prepareForWork(*database);
        return opened(std::move(database));
    });
}

Journal::Opened Journal::opened(std::shared_ptr<Database> database, std::shared_ptr<Identity> identity)
{
    ProjectContents contents = readContents(*database);
    Design design = designOf(*database, contents, contents.current);

    Opened result;
    if (!identity)
        identity = std::make_shared<Identity>(Identity{contents.uuid, {}});
    result.journal.reset(new Journal(database, std::move(identity)));
    Journal& journal = *result.journal;
    journal.m_base = contents.base;
    journal.m_seal = contents.seal;
    journal.m_redo = contents.redo;
    journal.m_current = contents.current;
    journal.m_design = design;
    journal.m_designHash.follow(design);
    for (std::size_t i = 0; i < contents.facts.size(); ++i) {
        const NodeId parent = contents.nodes[i].parent;
        const bool snapshot =
            std::binary_search(contents.snapshots.begin(), contents.snapshots.end(), static_cast<NodeId>(i));
        journal.m_rowHashes.push_back(contents.facts[i].rowHash);
        journal.m_sinceSnapshot.push_back(
            parent < 0 || snapshot ? 0 : journal.m_sinceSnapshot[static_cast<std::size_t>(parent)] + 1);
        journal.m_run = std::max(journal.m_run, contents.facts[i].run + 1);
    }
    result.project = bolster::opened(std::move(contents), std::move(design), std::move(database));
    return result;
}

Message Journal::guarded(const std::function<void()>& work)
{
    return caught([&] {
        const std::scoped_lock turn(*m_database);
        work();
    });
}

Message Journal::caught(const std::function<void()>& work)
{
    try {
        work();
        return {};
    } catch (const DatabaseError& error) {
        return error.message;
    } catch (const std::bad_alloc&) {
        return {QT_TRANSLATE_NOOP("Message", "there is not enough memory for this project"), {}};
    }
}

Message Journal::record(const History& history, const Design& design)
{
    Message problem = guarded([&] {
        Step step(*m_database, m_seal);
        std::optional<Design> there;
        for (auto id = static_cast<NodeId>(m_rowHashes.size()); id < history.count(); ++id) {
            const History::Node& node = history.node(id);
            there = there && node.parent == id - 1 ? there->with(node.edit) : history.designAt(id, design);
            if (!there)
                throw DatabaseError(
                    {QT_TRANSLATE_NOOP("Message", "an edit of the project cannot be read any more")});
            store(step, history, id, *there);
        }
        storeRedo(step, history);
        accept(step, history.current());
        m_design = design;
    });
    m_behind = !problem.empty();
    if (!m_behind && m_identity.use_count() == 1) // nobody stands in
        m_identity->uids.clear();
    return problem;
}

void Journal::store(Step& step, const History& history, NodeId id, const Design& design)
{
    const History::Node& node = history.node(id);
    const auto parent = static_cast<std::size_t>(node.parent);
    const std::size_t stored = m_rowHashes.size();
    const Hash chain = parent < stored ? m_rowHashes[parent] : step.rowHashes[parent - stored];
    const int since = 1 + (parent < stored ? m_sinceSnapshot[parent] : step.sinceSnapshot[parent - stored]);
    step.rowHashes.push_back(putNode(step.rows,
                                     {id, m_identity->uids.try_emplace(id, newUid()).first->second, node.parent,
                                      node.time.toMSecsSinceEpoch(), m_run, node.edit.verb,
                                      packChanges(fieldChanges(node.edit)), m_designHash.follow(design)},
                                     chain));
    const bool snapshot = since >= editsPerSnapshot;
    step.sinceSnapshot.push_back(snapshot ? 0 : since);
    if (snapshot)
        putSnapshot(step.rows, id, design);
}

/// From the current node up to the one that was current; above that nothing has changed. After a jump up to the
/// root, and after a step that could not be stored everything.
void Journal::storeRedo(Step& step, const History& history)
{
    const auto look = [&](NodeId id) {
        const History::Node& node = history.node(id);
        if (node.children.empty())
            return;
        const auto known = m_redo.find(id);
        if (node.lastVisitedChild == (known == m_redo.end() ? node.children.back() : known->second))
            return;
        step.redo[id] = node.lastVisitedChild;
        if (node.lastVisitedChild == node.children.back())
            step.rows.erase("redo", id);
        else
            step.rows.put("redo", {Value::integer(id), Value::integer(node.lastVisitedChild)});
    };
    if (m_behind)
        for (NodeId id = 0; id < history.count(); ++id)
            look(id);
    for (NodeId id = history.current(); id >= 0; id = id == m_current ? -1 : history.node(id).parent)
        look(id);
}

void Journal::accept(Step& step, NodeId current)
{
    step.rows.close(current);
    makeRoom(m_rowHashes, step.rowHashes.size()); // nothing may fail after the commit
    makeRoom(m_sinceSnapshot, step.sinceSnapshot.size());
    step.transaction.commit();
    m_seal = step.rows.seal();
    m_rowHashes.insert(m_rowHashes.end(), step.rowHashes.begin(), step.rowHashes.end());
    m_sinceSnapshot.insert(m_sinceSnapshot.end(), step.sinceSnapshot.begin(), step.sinceSnapshot.end());
    for (const auto& [parent, child] : step.redo)
        m_redo[parent] = child;
    m_current = current;
}

Message Journal::setNames(NodeId node, const std::string& version, const std::string& branch)
{
    return guarded([&] {
        Step step(*m_database, m_seal);
        putLabel(step.rows, node, version, branch);
        accept(step, m_current);
    });
}

Message Journal::addAsset(std::string& name, const QString& path)
{
    if (!isAssetName(name))
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is no name for a file of a project"), {name}};
    if (Message problem = ordinaryFileProblem(path); !problem.empty()) // one that waits for ever
        return problem;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be read (%2)"),
                {path.toStdString(), file.errorString().toStdString()}};
    return caught([&] {
        const std::scoped_lock one(m_longWork);
        NewBlob content(*m_database, file); // edits go on between its pieces
        const std::scoped_lock turn(*m_database);
        Step step(*m_database, m_seal);
        const std::int64_t blob = content.finish(step.rows);
        std::string free = name;
        for (int number = 2;; ++number) {
            const auto known = assetNumber(*m_database, free);
            if (!known)
                putAsset(*m_database, step.rows, free, blob);
            if (!known || *known == blob)
                break;
            free = numbered(name, number);
        }
        accept(step, m_current);
        name = free;
    });
}

bool Journal::hasAsset(const std::string& name)
{
    bool found = true; // not to be taken when that cannot be told
    guarded([&] { found = assetNumber(*m_database, name).has_value(); });
    return found;
}

Message Journal::extractAsset(const std::string& name, const QString& folder)
{
    return caught([&] { // edits go on between its pieces
        const auto blob = isAssetName(name) ? assetNumber(*m_database, name) : std::nullopt;
        if (!blob)
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "the file is missing"), {}});
        extractBlob(*m_database, *blob, QDir(folder).filePath(QDir::cleanPath(QString::fromStdString(name))));
    });
}

Message Journal::setThumbnail(NodeId node, const std::string& png)
{
    return guarded([&] {
        m_database->run("INSERT OR REPLACE INTO thumbnail VALUES(?, ?)", {Value::integer(node), Value::blob(png)});
    });
}

std::optional<Hash> Journal::base() const
{
    const std::scoped_lock turn(*m_database);
    return m_base;
}

void Journal::setBase(const Hash& seal)
{
    const std::scoped_lock turn(*m_database);
    m_base = seal;
    (void)caught([&] { // where it cannot be stored now, the versions tell later that the file is ours
        Step step(*m_database, m_seal);
        putProject(step.rows, uuid(), seal);
        accept(step, m_current);
    });
}

std::string Journal::thumbnail(NodeId node)
{
    std::string png;
    guarded([&] {
        Query query(*m_database, "SELECT png FROM thumbnail WHERE node = ?", {Value::integer(node)});
        if (query.next())
            png = query.blob(0);
    });
    return png;
}

} // namespace bolster
