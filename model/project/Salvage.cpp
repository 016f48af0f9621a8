#include "Salvage.h"

#include "BlobStore.h"
#include "DesignHash.h"
#include "ProjectContents.h"
#include "ProjectRows.h"
#include "ProjectWriter.h"
#include "Schema.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>

namespace bolster {
namespace {

constexpr std::size_t fileHeadSize = 100;

/// The head of a project file is the same in all of them but for these numbers: a damaged one is written anew.
void repairHead(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadWrite) || !file.resize(file.size() / pageSize * pageSize))
        return;
    QByteArray head = file.read(fileHeadSize);
    if (head.size() < static_cast<qsizetype>(fileHeadSize))
        return;
    const auto put = [&](qsizetype at, std::int64_t number) {
        for (int i = 3; i >= 0; --i, number >>= 8)
            head[at + i] = static_cast<char>(number);
    };
    head.replace(0, 16, QByteArray("SQLite format 3", 16));
    head.replace(16, 8, QByteArray("\x20\x00\x01\x01\x00\x40\x20\x20", 8));
    put(28, file.size() / pageSize);
    put(32, 0); // nothing is free: nothing will be written
    put(36, 0);
    put(44, 4);
    put(52, 0);
    put(56, 1);
    put(60, schemaVersion);
    put(64, 0);
    put(68, applicationId);
    head.replace(92, 4, head.mid(24, 4));
    file.seek(0);
    file.write(head);
}

/// A row whose bytes could be read; its hash may still be wrong.
struct Row {
    std::vector<Value> columns; // without the hash
    Hash hash{};

    bool trusted(std::string_view table, const Hash& chain = {}) const
    {
        return rowHash(table, columns, chain) == hash;
    }
};

/// Calls visit(row) if there is such a row that can be read.
template <class Visit>
void withRow(Database& database, const std::string& table, std::int64_t key, Visit visit)
{
    try {
        Query query(database, ("SELECT * FROM " + table + " WHERE rowid = ?").c_str(), {Value::integer(key)});
        if (!query.next())
            return;
        Row row;
        for (int i = 0; i + 1 < query.columns(); ++i)
            row.columns.push_back(query.value(i));
        row.hash = hashFrom(query.blob(query.columns() - 1));
        visit(row);
    } catch (const DatabaseError&) { // it is lost
    }
}

/// Every key of a table that can be found: on from each place that cannot be read.
std::set<std::int64_t> keysOf(Database& database, const std::string& table)
{
    constexpr int longestGap = 10'000; // keys tried one by one
    std::set<std::int64_t> keys;
    std::int64_t next = 0;
    for (int gap = 0; gap < longestGap; ++gap) {
        try {
            Query query(database, ("SELECT rowid FROM " + table + " WHERE rowid >= ? ORDER BY rowid").c_str(),
                        {Value::integer(next)});
            while (query.next()) {
                keys.insert(query.integer(0));
                next = query.integer(0) + 1;
                gap = 0;
            }
            break;
        } catch (const DatabaseError&) {
            ++next;
        }
    }
    return keys;
}

class Salvager {
public:
    Salvager(Database& from, Database& to)
        : m_from(from)
        , m_to(to)
        , m_rows(to, {})
    {}

    void run()
    {
        createTables(m_to);
        putProject(m_rows, newUid(), std::nullopt);
        const std::set<std::int64_t> snapshots = keysOf(m_from, "snapshot");
        std::set<std::int64_t> keys = keysOf(m_from, "node");
        keys.insert(snapshots.begin(), snapshots.end());
        std::int64_t next = 0;
        for (const std::int64_t key : keys) {
            if (key > largestElementId ||
                (!keepNode(static_cast<NodeId>(key)) && !keepSnapshot(static_cast<NodeId>(key))))
                continue;
            lose(next, key);
            next = key + 1;
        }
        if (!keys.empty())
            lose(next, *keys.rbegin() + 1);
        if (m_kept.empty())
            throw DatabaseError(
                {QT_TRANSLATE_NOOP("Message", "nothing in \"%1\" can be saved"), {m_from.path().toStdString()}});
        keepSnapshots(snapshots);
        keepLabels();
        keepAssets();
        m_rows.close(current());
    }

    std::vector<Message> notes() const
    {
        std::vector<Message> all;
        all.push_back({QT_TRANSLATE_NOOP("Message", "%1 versions were saved"), {std::to_string(m_kept.size())}});
        for (const auto& [first, last] : m_lost)
            all.push_back({QT_TRANSLATE_NOOP("Message", "lost: versions %1 to %2"),
                           {std::to_string(first), std::to_string(last)}});
        all.insert(all.end(), m_notes.begin(), m_notes.end());
        return all;
    }

private:
    void lose(std::int64_t begin, std::int64_t end)
    {
        if (begin < end)
            m_lost.emplace_back(begin, end - 1);
    }

    NodeId newId() const { return static_cast<NodeId>(m_kept.size()); }

    bool keepNode(NodeId id)
    {
        bool kept = false;
        withRow(m_from, "node", id, [&](const Row& row) {
            m_hashes[id] = row.hash; // even of one that is lost: its children can be told by it
            const bool isRoot = row.columns[2].type == Value::Type::Null;
            const auto parent = static_cast<NodeId>(row.columns[2].number);
            if (isRoot != (id == 0) || (!isRoot && !m_kept.contains(parent)) ||
                !row.trusted("node", isRoot ? Hash{} : m_hashes[parent]))
                return;
            NewNode node{newId(),
                         std::string(row.columns[1].bytes),
                         isRoot ? -1 : m_kept[parent],
                         row.columns[3].number,
                         row.columns[4].number,
                         {std::string(row.columns[5].bytes),
                          decodeTexts(row.columns[6].bytes).value_or(std::vector<std::string>())},
                         std::string(row.columns[7].bytes),
                         hashFrom(row.columns[8].bytes)};
            if (isRoot)
                if (const auto changes = unpackChanges(node.patch))
                    if (const auto edit = editOf(*changes, Design(), StoredEdits::Known::Parent))
                        m_first = Design().with(*edit);
            keep(id, node);
            kept = true;
        });
        return kept;
    }

    /// The way to it is lost, but what it led to is there: a branch from the beginning.
    bool keepSnapshot(NodeId id)
    {
        bool kept = false;
        withRow(m_from, "snapshot", id, [&](const Row& row) {
            const auto design = row.trusted("snapshot") ? decodeDesign(row.columns[2].bytes) : std::nullopt;
            if (!design)
                return;
            NewNode node = firstNode(*design);
            if (m_kept.empty()) {
                m_first = *design;
            } else {
                node.id = newId();
                node.parent = 0;
                node.verb = {QT_TRANSLATE_NOOP("Message", "Saved version")};
                node.patch = packChanges(fieldChanges(editBetween(m_first, *design, {})));
            }
            keep(id, node);
            m_notes.push_back({QT_TRANSLATE_NOOP("Message", "version %1 was saved without the edits before it"),
                               {std::to_string(id)}});
            kept = true;
        });
        return kept;
    }

    void keep(NodeId id, const NewNode& node)
    {
        const Hash chain = node.parent < 0 ? Hash{} : m_newHashes[static_cast<std::size_t>(node.parent)];
        m_newHashes.push_back(putNode(m_rows, node, chain));
        m_kept[id] = node.id;
    }

    void keepSnapshots(const std::set<std::int64_t>& keys)
    {
        for (const std::int64_t key : keys)
            withRow(m_from, "snapshot", key, [&](const Row& row) {
                const auto node = m_kept.find(static_cast<NodeId>(key));
                if (node != m_kept.end() && row.trusted("snapshot"))
                    m_rows.put("snapshot", {Value::integer(node->second), row.columns[1], row.columns[2]});
            });
    }

    void keepLabels()
    {
        std::size_t lost = 0;
        for (const std::int64_t key : keysOf(m_from, "label")) {
            ++lost;
            withRow(m_from, "label", key, [&](const Row& row) {
                const auto node = m_kept.find(static_cast<NodeId>(key));
                if (node == m_kept.end() || !row.trusted("label"))
                    return;
                m_rows.put("label", {Value::integer(node->second), row.columns[1], row.columns[2], row.columns[3]});
                --lost;
            });
        }
        if (lost > 0)
            m_notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "lost: the names of %1 versions"), {std::to_string(lost)}});
    }

    void keepAssets()
    {
        for (const std::int64_t key : keysOf(m_from, "asset"))
            withRow(m_from, "asset", key, [&](const Row& row) {
                const std::string name(row.columns[1].bytes);
                if (!isAssetName(name))
                    return;
                try {
                    if (!row.trusted("asset"))
                        throw DatabaseError({});
                    copyAsset(m_from, row.columns[2].number, name, m_to, m_rows);
                } catch (const DatabaseError&) {
                    m_notes.push_back({QT_TRANSLATE_NOOP("Message", "lost: the file \"%1\""), {name}});
                }
            });
    }

    NodeId current()
    {
        NodeId node = newId() - 1;
        withRow(m_from, "state", 0, [&](const Row& row) {
            const auto found = m_kept.find(static_cast<NodeId>(row.columns[1].number));
            if (row.trusted("state") && found != m_kept.end())
                node = found->second;
        });
        return node;
    }

    Database& m_from;
    Database& m_to;
    SealedRows m_rows;
    std::map<NodeId, Hash> m_hashes; // as they stand in the damaged file
    std::map<NodeId, NodeId> m_kept; // new numbers
    std::vector<Hash> m_newHashes;
    std::vector<std::pair<std::int64_t, std::int64_t>> m_lost;
    Design m_first; // of the new root
    std::vector<Message> m_notes;
};

/// From a copy, which was repaired.
std::vector<Message> salvage(const QString& copy, const QString& out)
{
    Database from(copy, Database::Access::AtRest);
    std::vector<Message> notes;
    replaceProject(
        out,
        [&](const QString& file) {
            Database to(file, Database::Access::Working);
            prepareUnshared(to);
            Transaction transaction(to);
            Salvager salvager(from, to);
            salvager.run();
            transaction.commit();
            notes = salvager.notes();
        },
        ProjectCheck::Everything);
    return notes;
}

} // namespace

Salvaged salvageProject(const QString& damaged, const QString& out)
{
    Salvaged result;
    if (QFileInfo::exists(out)) {
        result.readable = true;
        result.problem = {QT_TRANSLATE_NOOP("Message", "there is a file \"%1\" already"), {out.toStdString()}};
        return result;
    }
    const QTemporaryDir folder;
    const QString copy = folder.filePath("damaged");
    if (!QFile::copy(damaged, copy)) {
        result.problem = {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be read or copied"), {damaged.toStdString()}};
        return result;
    }
    QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
    repairHead(copy);
    try {
        result.notes = salvage(copy, out);
        result.readable = true;
    } catch (const DatabaseError& error) {
        result.problem = error.message;
    } catch (const std::bad_alloc&) {
        result.problem = {QT_TRANSLATE_NOOP("Message", "there is not enough memory for this project"), {}};
    }
    return result;
}

} // namespace bolster
