// How a journal becomes a project file.
#include "BlobStore.h"
#include "JournalStep.h"
#include "ProjectContents.h"
#include "ProjectRows.h"
#include "ProjectWriter.h"
#include "Schema.h"

namespace bolster {
namespace {

constexpr int editsWorthASnapshot = 100; // that stays

/// The last rows of a file that was written from a journal.
void finishFile(const QString& file, const ProjectContents& contents,
                const std::function<void(Database&, SealedRows&)>& more)
{
    Database database(file, Database::Access::Working);
    prepareUnshared(database);
    Transaction transaction(database);
    SealedRows rows(database, contents.seal);
    putProject(rows, contents.uuid, std::nullopt);
    more(database, rows);
    rows.close(contents.current);
    transaction.commit();
}

/// The names of files that only scans use, anywhere in the history.
std::set<std::string> scanFiles(Database& database, const ProjectContents& contents)
{
    std::set<ElementId> scans;
    std::set<std::string> ofScans, ofOthers; // as JSON
    const auto eachChange = [&](const auto& visit) {
        for (NodeId node = 0; node < static_cast<NodeId>(contents.nodes.size()); ++node)
            for (const FieldChange& change : changesOf(database, node).value_or(FieldChanges()))
                visit(change);
    };
    eachChange([&](const FieldChange& change) {
        if (change.field == "kind" && (change.after == "\"scan\"" || change.before == "\"scan\""))
            scans.insert(change.element);
    });
    eachChange([&](const FieldChange& change) {
        for (const auto& text : {change.before, change.after})
            if (change.field == "file" && text)
                (scans.contains(change.element) ? ofScans : ofOthers).insert(*text);
    });

    std::set<std::string> names;
    for (const auto& [name, blob] : contents.assets) {
        Scan scan;
        scan.file = name;
        const std::string text = elementFields(ElementId{1}, makeElement(scan)).at("file");
        if (ofScans.contains(text) && !ofOthers.contains(text))
            names.insert(name);
    }
    return names;
}

/// With the contents that no other asset has.
void removeAssets(Database& database, SealedRows& rows, const std::set<std::string>& names)
{
    for (const std::string& name : names) {
        Query asset(database, "SELECT id FROM asset WHERE name = ?", {Value::text(name)});
        if (asset.next())
            rows.erase("asset", asset.integer(0));
    }
    std::vector<std::int64_t> unused;
    Query blobs(database, "SELECT id FROM blob WHERE id NOT IN (SELECT blob FROM asset)");
    while (blobs.next())
        unused.push_back(blobs.integer(0));
    for (const std::int64_t blob : unused)
        removeBlob(database, rows, blob);
}

/// A project of its own that begins with the current design.
void writeCurrent(Database& from, const ProjectContents& contents, const Design& design, bool withScans,
                  const QString& file)
{
    Database to(file, Database::Access::Working);
    prepareUnshared(to);
    Transaction transaction(to);
    createTables(to);
    SealedRows rows(to, {});
    putProject(rows, newUid(), std::nullopt);
    putNode(rows, firstNode(design), {});
    putSnapshot(rows, 0, design); // a second copy
    std::set<std::string> names;
    for (const auto& [id, element] : design.elements())
        if (const std::string* name = elementFile(*element); name && contents.assets.contains(*name))
            if (withScans || !std::holds_alternative<Scan>(*element))
                names.insert(*name);
    for (const std::string& name : names)
        copyAsset(from, contents.assets.at(name), name, to, rows);
    rows.close(0);
    transaction.commit();
}

} // namespace

/// All rows as they are now, for one thread, while others go on working with the journal. When its disk does not
/// even take what was done out of the log, there is no work that could go on: then they wait.
class Journal::Moment {
public:
    explicit Moment(Database& journal)
        : m_journal(journal)
        , m_turn(journal)
    {}
    ~Moment()
    {
        m_frozen.reset();
        m_journal.thaw();
    }
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;

    /// Until then all others wait.
    void freeze()
    {
        try {
            m_frozen = m_journal.freeze();
            m_turn.unlock();
        } catch (const DatabaseError&) {
        }
    }
    Database& rows() { return m_frozen ? *m_frozen : m_journal; }

private:
    Database& m_journal;
    std::unique_lock<Database> m_turn;
    std::unique_ptr<Database> m_frozen;
};

Message Journal::save(const QString& path, HistoryMark* held)
{
    return caught([&] {
        const std::scoped_lock one(m_longWork);
        Moment moment(*m_database);
        removeUnfinishedBlobs(*m_database);
        (void)caught([&] { snapshotBeforeSave(); }); // a full disk of the journal's is no reason not to save
        ProjectContents contents;
        contents.uuid = uuid();
        contents.seal = m_seal;
        const HistoryMark now = mark();
        contents.current = now.current;
        moment.freeze();
        const Hash seal = replaceProject(path, [&](const QString& file) {
            moment.rows().vacuumInto(file);
            finishFile(file, contents, [&](Database& database, SealedRows& rows) {
                putSavePoint(database, rows, contents.current);
            });
        });
        if (held)
            *held = now;
        rememberSaved(seal, now.current);
    });
}

HistoryMark Journal::mark()
{
    NamesHash names;
    Query labels(*m_database, "SELECT node, version, branch FROM label ORDER BY node");
    while (labels.next())
        names.add(static_cast<NodeId>(labels.integer(0)), labels.value(1).bytes, labels.value(2).bytes);
    return {m_current, static_cast<NodeId>(m_rowHashes.size()), names.value()};
}

/// Where the journal's own disk is full, a comparison tells later that the file is ours.
void Journal::rememberSaved(const Hash& seal, NodeId version)
{
    const std::scoped_lock turn(*m_database);
    m_base = seal;
    (void)caught([&] {
        Step step(*m_database, m_seal);
        putProject(step.rows, uuid(), seal);
        putSavePoint(*m_database, step.rows, version);
        accept(step, m_current);
    });
}

Message Journal::saveCopy(const QString& path, const SaveOptions& options)
{
    return caught([&] {
        const std::scoped_lock one(m_longWork);
        Moment moment(*m_database);
        removeUnfinishedBlobs(*m_database);
        const Design design = m_design;
        moment.freeze();
        Database& now = moment.rows();
        const ProjectContents contents = readContents(now);
        replaceProject(path, [&](const QString& file) {
            if (!options.withHistory) {
                writeCurrent(now, contents, design, options.withScans, file);
                return;
            }
            const auto scans = options.withScans ? std::set<std::string>() : scanFiles(now, contents);
            now.vacuumInto(file);
            finishFile(file, contents,
                       [&](Database& database, SealedRows& rows) { removeAssets(database, rows, scans); });
            if (!scans.empty())
                Database(file, Database::Access::Working).vacuum();
        });
    });
}

/// A second copy of what is seen: no damage to one place of the file takes all of it, and it opens quickly. That of
/// the save before goes again, unless many edits lie before it.
void Journal::snapshotBeforeSave()
{
    if (Query(*m_database, "SELECT 1 FROM snapshot WHERE node = ?", {Value::integer(m_current)}).next())
        return;
    Step step(*m_database, m_seal);
    putSnapshot(step.rows, m_current, m_design);
    if (m_passingSnapshot >= 0)
        step.rows.erase("snapshot", m_passingSnapshot);
    accept(step, m_current);
    int& since = m_sinceSnapshot[static_cast<std::size_t>(m_current)];
    const bool stays = since >= editsWorthASnapshot;
    m_passingSnapshot = stays ? -1 : m_current;
    if (stays)
        since = 0;
}

} // namespace bolster
