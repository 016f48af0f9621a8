#include "Salvager.h"

#include "BlobStore.h"
#include "DesignHash.h"
#include "EditCodec.h"
#include "ProjectRows.h"
#include "ProjectWriter.h"
#include "SalvageRows.h"
#include "Schema.h"

#include <algorithm>
#include <ctime>

namespace bolster {
namespace {

double processorSeconds()
{
    timespec now = {};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Puts together again what leads from the first version on, and goes only where it leads to what was there.
class Salvager {
public:
    Salvager(Database& from, Database& to, double seconds)
        : m_from(from)
        , m_to(to)
        , m_rows(to, {})
        , m_seconds(seconds)
    {}

    void run()
    {
        createTables(m_to);
        putProject(m_rows, newUid(), std::nullopt);
        const std::set<std::int64_t> snapshots = m_from.keys("snapshot");
        std::set<std::int64_t> keys = m_from.keys("node");
        countChildren(keys);
        keys.insert(snapshots.begin(), snapshots.end());
        std::int64_t next = 0;
        for (const std::int64_t key : keys) {
            if (key > largestElementId || m_late || !keepVersion(static_cast<NodeId>(key)))
                continue;
            lose(next, key);
            next = key + 1;
        }
        if (!keys.empty())
            lose(next, *keys.rbegin() + 1);
        if (m_kept.empty())
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "nothing in \"%1\" can be saved"),
                                 {m_from.database().name().toStdString()}});
        keepLabels();
        keepAssets();
        m_rows.close(current());
    }

    std::vector<Message> notes() const
    {
        constexpr std::size_t mostGaps = 1'000;
        std::vector<Message> all;
        all.push_back(m_kept.size() == 1 ? Message{QT_TRANSLATE_NOOP("Message", "one version was saved"), {}}
                                         : Message{QT_TRANSLATE_NOOP("Message", "%1 versions were saved"),
                                                   {std::to_string(m_kept.size())}});
        for (const std::string& table : m_from.lostTables())
            all.push_back(
                {QT_TRANSLATE_NOOP("Message", "lost: the table \"%1\", which is missing or has other columns "
                                              "than it should"),
                 {table}});
        for (std::size_t i = 0; i < std::min(m_lost.size(), mostGaps); ++i)
            all.push_back({QT_TRANSLATE_NOOP("Message", "lost: versions %1 to %2"),
                           {std::to_string(m_lost[i].first), std::to_string(m_lost[i].second)}});
        if (m_lost.size() > mostGaps)
            all.push_back({QT_TRANSLATE_NOOP("Message", "lost: %1 more such gaps"),
                           {std::to_string(m_lost.size() - mostGaps)}});
        if (m_late)
            all.push_back({QT_TRANSLATE_NOOP("Message", "what comes after version %1 takes too long to recover"),
                           {std::to_string(m_kept.rbegin()->first)}});
        all.insert(all.end(), m_notes.begin(), m_notes.end());
        return all;
    }

private:
    void lose(std::int64_t begin, std::int64_t end)
    {
        if (begin < end)
            m_lost.emplace_back(begin, end - 1);
    }

    void note(Message message)
    {
        constexpr std::size_t mostNotes = 1'000;
        if (m_notes.size() < mostNotes)
            m_notes.push_back(std::move(message));
    }

    NodeId newId() const { return static_cast<NodeId>(m_kept.size()); }

    /// So that only those designs are held that others follow from.
    void countChildren(const std::set<std::int64_t>& keys)
    {
        for (const std::int64_t key : keys)
            if (const auto row = m_from.row("node", key); row && !row->isNull(2))
                ++m_childrenLeft[row->number(2)];
    }

    bool keepVersion(NodeId id)
    {
        m_late = processorSeconds() > m_seconds && !m_kept.empty();
        if (m_late)
            return false;
        const auto row = m_from.row("node", id);
        const auto snapshot = m_from.row("snapshot", id);
        if (row)
            m_hashes[id] = row->hash(); // even of one that is lost: its children can be told by it
        const bool kept = (row && keepNode(id, *row, snapshot)) || (snapshot && keepSnapshot(id, *snapshot));
        if (row && !row->isNull(2) && --m_childrenLeft[row->number(2)] <= 0)
            m_designs.erase(row->number(2));
        return kept;
    }

    bool keepNode(NodeId id, const SalvagedRow& row, const std::optional<SalvagedRow>& snapshot)
    {
        const bool isRoot = row.isNull(2);
        const std::int64_t parent = isRoot ? -1 : row.number(2);
        const auto above = m_designs.find(parent);
        if (isRoot != (id == 0) || (!isRoot && above == m_designs.end()) ||
            !row.trusted(isRoot ? Hash{} : m_hashes[static_cast<NodeId>(parent)]))
            return false;
        const auto args = decodeTexts(row.bytes(6));
        const auto changes = unpackChanges(row.bytes(7));
        const auto design = changes ? replayed(isRoot ? Replayed() : above->second, *changes) : std::nullopt;
        if (!args || !design || row.bytes(1).size() != uidBytes ||
            bytesOf(hashAfter(design->design)) != row.bytes(8)) {
            note({QT_TRANSLATE_NOOP("Message", "the edit of version %1 does not lead to the design that was kept "
                                               "with it"),
                  {std::to_string(id)}});
            return false;
        }
        keep(id, *design,
             {newId(),
              row.bytes(1),
              isRoot ? -1 : m_kept.at(static_cast<NodeId>(parent)),
              row.number(3),
              row.number(4),
              {row.bytes(5), *args},
              row.bytes(7),
              hashFrom(row.bytes(8))});
        if (snapshot && snapshot->trusted() && snapshot->number(1) == 1)
            if (const auto there = decodeDesign(snapshot->bytes(2)); there && there->design == design->design)
                m_rows.put("snapshot", {Value::integer(m_kept.at(id)), snapshot->value(1), snapshot->value(2)});
        return true;
    }

    /// The way to it is lost, but what it led to is there: a branch from the beginning.
    bool keepSnapshot(NodeId id, const SalvagedRow& row)
    {
        const auto design = row.trusted() && row.number(1) == 1 ? decodeDesign(row.bytes(2)) : std::nullopt;
        if (!design)
            return false;
        NewNode node = firstNode(design->design);
        if (!m_kept.empty()) {
            node.id = newId();
            node.parent = 0;
            node.verb = {QT_TRANSLATE_NOOP("Message", "Saved version")};
            node.patch = packChanges(fieldChanges(editBetween(m_first, design->design, {})));
        }
        keep(id, *design, node);
        note({QT_TRANSLATE_NOOP("Message", "version %1 was saved without the edits before it"),
              {std::to_string(id)}});
        return true;
    }

    void keep(NodeId id, const Replayed& design, const NewNode& node)
    {
        if (m_kept.empty())
            m_first = design.design;
        if (m_childrenLeft.contains(id))
            m_designs[id] = design;
        const Hash chain = node.parent < 0 ? Hash{} : m_newHashes[static_cast<std::size_t>(node.parent)];
        m_newHashes.push_back(putNode(m_rows, node, chain));
        m_kept[id] = node.id;
    }

    Hash hashAfter(const Design& design) { return m_designHash.follow(design); }

    void keepLabels()
    {
        std::size_t lost = 0;
        for (const std::int64_t key : m_from.keys("label")) {
            const auto row = m_from.row("label", key);
            const auto node = m_kept.find(static_cast<NodeId>(key));
            if (key <= largestElementId && row && row->trusted() && node != m_kept.end())
                m_rows.put("label", {Value::integer(node->second), row->value(1), row->value(2), row->value(3)});
            else
                ++lost;
        }
        if (lost > 0)
            note({QT_TRANSLATE_NOOP("Message", "lost: the names of %1 versions"), {std::to_string(lost)}});
    }

    void keepAssets()
    {
        std::set<std::string> places;
        const bool contents = !m_from.lostTables().contains("blob") && !m_from.lostTables().contains("chunk");
        for (const std::int64_t key : m_from.keys("asset")) {
            const auto row = m_from.row("asset", key);
            if (!row || !isAssetName(row->bytes(1)))
                continue;
            const std::string& name = row->bytes(1);
            if (!contents || !row->trusted() || !places.insert(assetPlace(name)).second ||
                !copied(row->number(2), name))
                note({QT_TRANSLATE_NOOP("Message", "lost: the file \"%1\""), {name}});
        }
    }

    /// Whether it is whole; what cannot be written is another matter.
    bool copied(std::int64_t blob, const std::string& name)
    {
        try {
            readBlob(m_from.database(), blob, nullptr);
        } catch (const DatabaseError&) {
            return false;
        }
        copyAsset(m_from.database(), blob, name, m_to, m_rows);
        return true;
    }

    NodeId current()
    {
        const auto row = m_from.row("state", 0);
        const auto found = row && row->trusted() ? m_kept.find(static_cast<NodeId>(row->number(1))) : m_kept.end();
        return found == m_kept.end() ? newId() - 1 : found->second;
    }

    static constexpr std::size_t uidBytes = 16;

    SalvagedRows m_from;
    Database& m_to;
    SealedRows m_rows;
    double m_seconds;
    bool m_late = false;
    std::map<std::int64_t, int> m_childrenLeft;
    std::map<std::int64_t, Replayed> m_designs; // of those that have children left
    DesignHash m_designHash;
    std::map<NodeId, Hash> m_hashes; // as they stand in the damaged file
    std::map<NodeId, NodeId> m_kept; // new numbers
    std::vector<Hash> m_newHashes;
    std::vector<std::pair<std::int64_t, std::int64_t>> m_lost;
    Design m_first; // of the new root
    std::vector<Message> m_notes;
};

std::vector<Message> salvaged(const SalvageWork& work)
{
    Database from(work.copy, Database::Access::AtRest);
    from.setName(work.name);
    std::vector<Message> notes;
    replaceProject(work.out, [&](const QString& file) {
        Database to(file, Database::Access::Working);
        to.setName(work.out);
        prepareUnshared(to);
        Transaction transaction(to);
        Salvager salvager(from, to, work.seconds);
        salvager.run();
        transaction.commit();
        notes = salvager.notes();
    });
    return notes;
}

} // namespace

Salvaged salvageHere(const SalvageWork& work)
{
    Salvaged result;
    try {
        result.notes = salvaged(work);
        result.readable = true;
    } catch (const DatabaseError& error) {
        result.problem = error.message;
    } catch (const std::bad_alloc&) {
        result.problem = {QT_TRANSLATE_NOOP("Message", "there is not enough memory for this project"), {}};
    }
    return result;
}

std::string bytesOf(const Salvaged& salvaged)
{
    std::vector<Message> all = {{salvaged.readable ? "readable" : "damaged"}, salvaged.problem};
    all.insert(all.end(), salvaged.notes.begin(), salvaged.notes.end());
    std::string bytes;
    for (const Message& message : all) {
        std::vector<std::string> texts = {message.key};
        texts.insert(texts.end(), message.args.begin(), message.args.end());
        const std::string list = encodeTexts(texts);
        bytes += std::to_string(list.size()) + ' ' + list;
    }
    return bytes;
}

std::optional<Salvaged> salvagedFrom(std::string_view bytes)
{
    std::vector<Message> all;
    while (!bytes.empty()) {
        std::size_t length = 0;
        while (!bytes.empty() && bytes[0] >= '0' && bytes[0] <= '9' && length < bytes.size()) {
            length = 10 * length + static_cast<std::size_t>(bytes[0] - '0');
            bytes.remove_prefix(1);
        }
        if (bytes.empty() || length >= bytes.size())
            return std::nullopt;
        const auto texts = decodeTexts(bytes.substr(1, length));
        if (!texts || texts->empty())
            return std::nullopt;
        all.push_back({texts->front(), {texts->begin() + 1, texts->end()}});
        bytes.remove_prefix(1 + length);
    }
    if (all.size() < 2)
        return std::nullopt;
    return Salvaged{all[1], all[0].key == "readable", {all.begin() + 2, all.end()}};
}

} // namespace bolster
