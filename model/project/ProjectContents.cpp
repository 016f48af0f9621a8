#include "ProjectContents.h"

#include "BlobStore.h"
#include "DesignHash.h"
#include "FieldReplay.h"
#include "Schema.h"

#include <algorithm>

namespace bolster {
namespace {

constexpr std::int64_t mostNodes = 10'000'000;
// Of all edits and snapshots, unpacked. Those of designers pack to a fifth, and a few large ones may pack better.
constexpr std::uint64_t plainAtLeast = 128u << 20;
constexpr std::uint64_t plainPerByte = 32;

[[noreturn]] void refuse(const Database& database, const char* table, std::int64_t key)
{
    throw DatabaseError(
        {QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged: row %2 of the table \"%3\" contradicts others"),
         {database.name().toStdString(), std::to_string(key), table}});
}

/// Counts what the edits and snapshots of a project say they unpack to. A file that holds little and promises much
/// is refused before anybody unpacks it.
class PlainSum {
public:
    explicit PlainSum(Database& database)
        : m_most(plainAtLeast + plainPerByte * static_cast<std::uint64_t>(database.bytes()))
        , m_database(database)
    {}

    void add(std::string_view bytes)
    {
        const auto length = unpackedLength(bytes);
        m_sum += length.value_or(0);
        if (!length || m_sum > m_most)
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "\"%1\" unpacks to more than any project; it was not "
                                                              "made by Bolster, or is damaged"),
                                 {m_database.name().toStdString()}});
    }

private:
    std::uint64_t m_most;
    std::uint64_t m_sum = 0;
    Database& m_database;
};

/// Whether a column's number is one of the nodes read so far.
bool isNode(const ProjectContents& contents, const Value& value)
{
    return value.type == Value::Type::Integer && value.number >= 0 &&
           value.number < static_cast<std::int64_t>(contents.nodes.size());
}

void readProject(Database& database, ProjectContents& contents)
{
    int count = 0;
    eachRow(database, "project", contents.seal, [&](std::span<const Value> row, const Hash&) {
        contents.uuid = row[1].bytes;
        if (row[3].type == Value::Type::Blob)
            contents.base = hashFrom(row[3].bytes);
        ++count;
    });
    if (count != 1)
        refuse(database, "project", count);
}

void readNode(const Database& database, ProjectContents& contents, std::span<const Value> row, const Hash& hash)
{
    const auto id = static_cast<std::int64_t>(contents.nodes.size());
    const bool parentRight = id == 0 ? row[2].type == Value::Type::Null : isNode(contents, row[2]);
    auto args = decodeTexts(row[6].bytes);
    ProjectNode facts;
    if (row[0].number != id || id >= mostNodes || !parentRight || !args || row[1].bytes.size() != facts.uid.size())
        refuse(database, "node", row[0].number);
    std::copy(row[1].bytes.begin(), row[1].bytes.end(), facts.uid.begin());
    facts.run = row[4].number;
    facts.designHash = hashFrom(row[8].bytes);
    facts.rowHash = hash;
    contents.facts.push_back(facts);

    History::Node node;
    node.parent = id == 0 ? -1 : static_cast<NodeId>(row[2].number);
    node.edit.verb = {std::string(row[5].bytes), std::move(*args)};
    node.time = QDateTime::fromMSecsSinceEpoch(row[3].number, Qt::UTC);
    contents.nodes.push_back(std::move(node));
}

void readNodes(Database& database, ProjectContents& contents, PlainSum& plain)
{
    eachRow(
        database, "node", contents.seal,
        [&](std::span<const Value> row, const Hash& hash) {
            plain.add(row[7].bytes);
            readNode(database, contents, row, hash);
        },
        [&](std::span<const Value> row) {
            return isNode(contents, row[2]) ? contents.facts[static_cast<std::size_t>(row[2].number)].rowHash
                                            : Hash{};
        });
    if (contents.nodes.empty())
        refuse(database, "node", 0);
}

void readWhatRefersToNodes(Database& database, ProjectContents& contents, PlainSum& plain)
{
    const auto nodeAt = [&](NodeId id) -> History::Node& { return contents.nodes[static_cast<std::size_t>(id)]; };
    eachRow(database, "label", contents.seal, [&](std::span<const Value> row, const Hash&) {
        if (!isNode(contents, row[0]))
            refuse(database, "label", row[0].number);
        History::Node& node = nodeAt(static_cast<NodeId>(row[0].number));
        node.name = row[1].bytes;
        node.branch = row[2].bytes;
    });
    eachRow(database, "redo", contents.seal, [&](std::span<const Value> row, const Hash&) {
        if (!isNode(contents, row[0]) || !isNode(contents, row[1]) ||
            nodeAt(static_cast<NodeId>(row[1].number)).parent != row[0].number)
            refuse(database, "redo", row[0].number);
        contents.redo.emplace(row[0].number, row[1].number);
        nodeAt(static_cast<NodeId>(row[0].number)).lastVisitedChild = static_cast<NodeId>(row[1].number);
    });
    eachRow(database, "snapshot", contents.seal, [&](std::span<const Value> row, const Hash&) {
        if (!isNode(contents, row[0]))
            refuse(database, "snapshot", row[0].number);
        plain.add(row[2].bytes);
        contents.snapshots.push_back(static_cast<NodeId>(row[0].number));
    });
    eachRow(database, "save_point", contents.seal, [&](std::span<const Value> row, const Hash&) {
        if (!isNode(contents, row[2]))
            refuse(database, "save_point", row[0].number);
        contents.saved = static_cast<NodeId>(row[2].number);
    });
}

void readAssets(Database& database, ProjectContents& contents)
{
    std::set<std::int64_t> blobs;
    eachRow(database, "blob", contents.seal, [&](std::span<const Value> row, const Hash&) {
        if (!isBlobNumber(row[0].number))
            refuse(database, "blob", row[0].number);
        blobs.insert(row[0].number);
    });
    std::set<std::string> places;
    eachRow(database, "asset", contents.seal, [&](std::span<const Value> row, const Hash&) {
        const std::string name(row[1].bytes);
        if (!blobs.contains(row[2].number) || !isAssetName(name) || !places.insert(assetPlace(name)).second)
            refuse(database, "asset", row[0].number);
        contents.assets.emplace(name, row[2].number);
    });
}

void readState(Database& database, ProjectContents& contents)
{
    HashSum ignored;
    int count = 0;
    eachRow(database, "state", ignored, [&](std::span<const Value> row, const Hash&) {
        if (row[0].number != 0 || !isNode(contents, row[1]))
            refuse(database, "state", row[0].number);
        contents.current = static_cast<NodeId>(row[1].number);
        if (hashFrom(row[2].bytes) != contents.seal.value())
            throw DatabaseError(
                {QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged: rows are missing, or there are some too many"),
                 {database.name().toStdString()}});
        ++count;
    });
    if (count != 1)
        refuse(database, "state", count);
}

class StoredNodes : public StoredEdits {
public:
    explicit StoredNodes(std::shared_ptr<Database> database)
        : m_database(std::move(database))
    {}

    std::optional<Edit> edit(NodeId node, const Design& design, Known known) override
    {
        try {
            const auto changes = changesOf(*m_database, node);
            return changes ? editOf(*changes, design, known) : std::nullopt;
        } catch (const DatabaseError&) {
            return std::nullopt;
        }
    }

private:
    std::shared_ptr<Database> m_database;
};

[[noreturn]] void refuseDesign(const Database& database, NodeId node)
{
    throw DatabaseError(
        {QT_TRANSLATE_NOOP("Message",
                           "\"%1\" is damaged: the edits up to number %2 do not lead to the design that was "
                           "stored with them"),
         {database.name().toStdString(), std::to_string(node)}});
}

Replayed stepped(Database& database, NodeId node, const Replayed& parent)
{
    const auto changes = changesOf(database, node);
    auto next = changes ? replayed(parent, *changes) : std::nullopt;
    if (!next)
        refuseDesign(database, node);
    return std::move(*next);
}

/// Walks the whole tree and keeps only the designs that have children to come.
class DesignWalk {
public:
    DesignWalk(Database& database, const ProjectContents& contents)
        : m_database(database)
        , m_contents(contents)
        , m_childrenLeft(contents.nodes.size())
    {
        for (const History::Node& node : contents.nodes)
            if (node.parent >= 0)
                ++m_childrenLeft[static_cast<std::size_t>(node.parent)];
    }

    /// Returns how many it has come to.
    std::int64_t run(bool toTheEnd)
    {
        const auto count = static_cast<NodeId>(m_contents.nodes.size());
        for (NodeId id = 0; id < count; ++id) {
            if (!toTheEnd && (m_handled > mostHandled || m_held > mostHeld))
                return id;
            step(id);
        }
        return count;
    }

private:
    // An edit is cheap only to whoever makes it: here the elements that it changes are written and read, and the
    // list of all elements is copied, which takes as long for each as a few bytes of text. So many bytes take some
    // seconds, and designs of so many can be held.
    static constexpr std::int64_t mostHandled = 200 << 20;
    static constexpr std::int64_t textOfEntry = 4;
    static constexpr std::int64_t mostHeld = 50 << 20;
    static constexpr std::int64_t memoryOfEntry = 64;

    void step(NodeId id)
    {
        const NodeId parent = m_contents.nodes[static_cast<std::size_t>(id)].parent;
        const Replayed next = stepped(m_database, id, parent < 0 ? Replayed() : m_designs.at(parent).design);
        if (m_hash.follow(next.design) != m_contents.facts[static_cast<std::size_t>(id)].designHash)
            refuseDesign(m_database, id);
        const auto entries = static_cast<std::int64_t>(next.design.elements().size());
        m_handled += next.handled + textOfEntry * entries;
        if (std::binary_search(m_contents.snapshots.begin(), m_contents.snapshots.end(), id))
            compareSnapshot(id, next.design);
        if (m_childrenLeft[static_cast<std::size_t>(id)] > 0) {
            const std::int64_t bytes = next.handled + memoryOfEntry * entries;
            m_designs.emplace(id, Held{next, bytes});
            m_held += bytes;
        }
        if (parent >= 0 && --m_childrenLeft[static_cast<std::size_t>(parent)] == 0) {
            m_held -= m_designs.at(parent).bytes;
            m_designs.erase(parent);
        }
    }

    void compareSnapshot(NodeId id, const Design& design)
    {
        const std::optional<Replayed> snapshot = snapshotOf(m_database, id);
        if (!snapshot || snapshot->design != design)
            refuse(m_database, "snapshot", id);
        m_handled += snapshot->handled;
    }

    struct Held {
        Replayed design;
        std::int64_t bytes = 0;
    };

    Database& m_database;
    const ProjectContents& m_contents;
    std::vector<int> m_childrenLeft;
    DesignHash m_hash;
    std::map<NodeId, Held> m_designs;
    std::int64_t m_handled = 0;
    std::int64_t m_held = 0;
};

} // namespace

ProjectContents readContents(Database& database)
{
    checkTables(database);
    Query check(database, "PRAGMA quick_check(1)");
    if (!check.next() || check.text(0) != "ok")
        throw DatabaseError({QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged: parts of the file are not what was "
                                                          "written"),
                             {database.name().toStdString()}});
    ProjectContents contents;
    readProject(database, contents);
    PlainSum plain(database);
    readNodes(database, contents, plain);
    readWhatRefersToNodes(database, contents, plain);
    readAssets(database, contents);
    readState(database, contents);
    return contents;
}

std::optional<FieldChanges> changesOf(Database& database, NodeId node)
{
    Query query(database, "SELECT patch FROM node WHERE id = ?", {Value::integer(node)});
    return query.next() ? unpackChanges(query.blob(0)) : std::nullopt;
}

std::optional<Replayed> snapshotOf(Database& database, NodeId node)
{
    Query query(database, "SELECT codec, data FROM snapshot WHERE node = ?", {Value::integer(node)});
    return query.next() && query.integer(0) == 1 ? decodeDesign(query.blob(1)) : std::nullopt;
}

Design designOf(Database& database, const ProjectContents& contents, NodeId node)
{
    std::vector<NodeId> steps; // last first
    std::optional<Replayed> design;
    for (NodeId at = node; at >= 0 && !design; at = contents.nodes[static_cast<std::size_t>(at)].parent) {
        if (std::binary_search(contents.snapshots.begin(), contents.snapshots.end(), at))
            design = snapshotOf(database, at);
        if (!design)
            steps.push_back(at);
    }
    if (!design)
        design.emplace();
    FieldReplay replay(std::move(*design));
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        const auto changes = changesOf(database, *step);
        if (!changes || !replay.add(*changes))
            refuseDesign(database, *step);
    }
    design = replay.result();
    if (!design || hashOf(design->design) != contents.facts[static_cast<std::size_t>(node)].designHash)
        refuseDesign(database, node);
    return design->design;
}

std::int64_t checkThoroughly(Database& database, const ProjectContents& contents, ProjectCheck check)
{
    Query blobs(database, "SELECT id FROM blob");
    while (blobs.next())
        readBlob(database, blobs.integer(0), nullptr);
    if (hasForeignChunks(database))
        refuse(database, "chunk", 0);
    return DesignWalk(database, contents).run(check == ProjectCheck::Everything);
}

std::shared_ptr<StoredEdits> storedEdits(std::shared_ptr<Database> database)
{
    return std::make_shared<StoredNodes>(std::move(database));
}

OpenedProject opened(ProjectContents contents, Design design, std::shared_ptr<Database> database)
{
    OpenedProject project;
    project.uuid = std::move(contents.uuid);
    project.design = std::move(design);
    project.history = History(std::move(contents.nodes), contents.current, storedEdits(database));
    project.nodes = std::move(contents.facts);
    project.saved = contents.saved;
    project.seal = contents.seal.value();
    project.base = contents.base;
    project.assets = std::move(contents.assets);
    project.database = std::move(database);
    return project;
}

} // namespace bolster
