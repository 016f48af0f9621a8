// What somebody else has made of a project, in the file that a journal belongs to.
#include "BlobStore.h"
#include "JournalStep.h"
#include "ProjectContents.h"
#include "ProjectRows.h"
#include "ProjectWriter.h"

#include <algorithm>

namespace bolster {
namespace {

using Uid = std::array<std::uint8_t, 16>;

Uid uidFrom(std::string_view bytes)
{
    Uid uid = {};
    std::copy_n(bytes.begin(), std::min(bytes.size(), uid.size()), uid.begin());
    return uid;
}

std::map<Uid, NodeId> nodesByUid(Database& database)
{
    std::map<Uid, NodeId> nodes;
    Query query(database, "SELECT id, uid FROM node");
    while (query.next())
        nodes.emplace(uidFrom(query.blob(1)), static_cast<NodeId>(query.integer(0)));
    return nodes;
}

/// Our numbers of their nodes; -1 for those that are not here.
std::vector<NodeId> placesOf(const OpenedProject& theirs, Database& ours)
{
    const std::map<Uid, NodeId> known = nodesByUid(ours);
    std::vector<NodeId> places;
    for (const ProjectNode& node : theirs.nodes) {
        const auto found = known.find(node.uid);
        places.push_back(found == known.end() ? -1 : found->second);
    }
    return places;
}

std::string contentOf(Database& database, std::int64_t blob)
{
    Query query(database, "SELECT hash FROM blob WHERE id = ?", {Value::integer(blob)});
    return query.next() ? std::string(query.blob(0)) : std::string();
}

void takeAssets(const OpenedProject& theirs, Database& ours, SealedRows& rows)
{
    for (const auto& [name, blob] : theirs.assets) {
        Query known(ours, "SELECT blob FROM asset WHERE name = ?", {Value::text(name)});
        if (!known.next())
            copyAsset(*theirs.database, blob, name, ours, rows);
        else if (contentOf(ours, known.integer(0)) != contentOf(*theirs.database, blob))
            throw DatabaseError(
                {QT_TRANSLATE_NOOP("Message", "both have a file \"%1\", and they are different: save "
                                              "under another name"),
                 {name}});
    }
}

/// Their row with the numbers that it gets here.
NewNode newNode(const OpenedProject& theirs, NodeId node, NodeId id, NodeId parent)
{
    Query row(*theirs.database, "SELECT uid, at, run, verb, args, patch, doc_hash FROM node WHERE id = ?",
              {Value::integer(node)});
    if (!row.next())
        throw DatabaseError({QT_TRANSLATE_NOOP("Message", "an edit of the project cannot be read any more")});
    return {id,
            std::string(row.blob(0)),
            parent,
            row.integer(1),
            row.integer(2),
            {std::string(row.text(3)), decodeTexts(row.blob(4)).value_or(std::vector<std::string>())},
            std::string(row.blob(5)),
            hashFrom(row.blob(6))};
}

} // namespace

Journal::Theirs Journal::compare(const OpenedProject& theirs)
{
    const std::scoped_lock turn(*m_database);
    if (theirs.uuid != uuid())
        return Theirs::AnotherProject;
    const std::vector<NodeId> places = placesOf(theirs, *m_database);
    for (NodeId node = 0; node < theirs.history.count(); ++node) {
        const NodeId place = places[static_cast<std::size_t>(node)];
        if (place < 0)
            return Theirs::MoreVersions;
        Query ours(*m_database, "SELECT version, branch FROM label WHERE node = ?", {Value::integer(place)});
        const bool named = ours.next();
        const auto lacks = [&](int column, const std::string& name) {
            return !name.empty() && (!named || ours.value(column).bytes.empty());
        };
        if (lacks(0, theirs.history.node(node).name) || lacks(1, theirs.history.node(node).branch))
            return Theirs::MoreVersions;
    }
    return Theirs::NothingNew;
}

bool Journal::isIn(const OpenedProject& file)
{
    std::map<std::string, NodeId> there;
    for (NodeId node = 0; node < static_cast<NodeId>(file.nodes.size()); ++node) {
        const Uid& uid = file.nodes[static_cast<std::size_t>(node)].uid;
        there[std::string(uid.begin(), uid.end())] = node;
    }
    bool all = file.uuid == uuid();
    const Message problem = guarded([&] {
        Query ours(*m_database, "SELECT node.uid, label.version, label.branch FROM node LEFT JOIN label ON "
                                "label.node = node.id");
        while (all && ours.next()) {
            const auto found = there.find(std::string(ours.blob(0)));
            all = found != there.end() && file.history.node(found->second).name == ours.value(1).bytes &&
                  file.history.node(found->second).branch == ours.value(2).bytes;
        }
    });
    return all && problem.empty();
}

Message Journal::takeIn(const OpenedProject& theirs, const std::string& name, const History& history,
                        TakenIn& taken)
{
    return guarded([&] {
        if (theirs.uuid != uuid() || theirs.history.count() == 0)
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "there is another project in the file now")});
        if (m_behind || static_cast<NodeId>(m_rowHashes.size()) != history.count())
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "the last edits are not on the disk yet")});
        Step step(*m_database, m_seal);
        std::vector<NodeId> places = placesOf(theirs, *m_database);
        taken = {};
        for (NodeId node = 0; node < theirs.history.count(); ++node)
            takeNode(step, theirs, node, places, taken);
        taken.tip = places[static_cast<std::size_t>(theirs.history.current())];
        if (!taken.nodes.empty())
            takeAssets(theirs, *m_database, step.rows);
        takeNames(step, theirs, places, history, name, taken);
        keepRedo(step, history, taken);
        putProject(step.rows, uuid(), theirs.seal);
        accept(step, m_current);
        m_base = theirs.seal;
        taken.edits = storedEdits(m_database);
    });
}

void Journal::takeNode(Step& step, const OpenedProject& theirs, NodeId node, std::vector<NodeId>& places,
                       TakenIn& taken)
{
    NodeId& place = places[static_cast<std::size_t>(node)];
    if (place >= 0)
        return;
    const History::Node& facts = theirs.history.node(node);
    const NodeId parent = facts.parent < 0 ? -1 : places[static_cast<std::size_t>(facts.parent)];
    if (parent < 0)
        throw DatabaseError({QT_TRANSLATE_NOOP("Message", "there is another project in the file now")});
    const std::size_t stored = m_rowHashes.size();
    place = static_cast<NodeId>(stored + step.rowHashes.size());
    const auto above = static_cast<std::size_t>(parent);
    const Hash chain = above < stored ? m_rowHashes[above] : step.rowHashes[above - stored];
    const int since = above < stored ? m_sinceSnapshot[above] : step.sinceSnapshot[above - stored];
    step.rowHashes.push_back(putNode(step.rows, newNode(theirs, node, place, parent), chain));
    Query snapshot(*theirs.database, "SELECT codec, data FROM snapshot WHERE node = ?", {Value::integer(node)});
    const bool withSnapshot = snapshot.next();
    if (withSnapshot)
        step.rows.put("snapshot", {Value::integer(place), snapshot.value(0), snapshot.value(1)});
    step.sinceSnapshot.push_back(withSnapshot ? 0 : since + 1);
    taken.nodes.push_back({parent, {}, -1, {facts.edit.verb, {}}, facts.time, {}, {}});
}

/// Ours stay where both have named something.
void Journal::takeNames(Step& step, const OpenedProject& theirs, const std::vector<NodeId>& places,
                        const History& history, const std::string& name, TakenIn& taken)
{
    for (NodeId node = 0; node < theirs.history.count(); ++node) {
        const NodeId place = places[static_cast<std::size_t>(node)];
        std::string text = theirs.history.node(node).name;
        const bool known = place < history.count();
        if (text.empty() && place == taken.tip && !known)
            text = name;
        const std::string& branch = theirs.history.node(node).branch;
        if (!known) {
            putLabel(step.rows, place, text, branch);
            History::Node& added = taken.nodes[static_cast<std::size_t>(place - history.count())];
            added.name = text;
            added.branch = branch;
            continue;
        }
        const History::Node& ours = history.node(place);
        if (ours.name.empty() && !text.empty())
            taken.names[place] = text;
        if (ours.branch.empty() && !branch.empty())
            taken.branches[place] = branch;
        if (taken.names.contains(place) || taken.branches.contains(place))
            putLabel(step.rows, place, ours.name.empty() ? text : ours.name,
                     ours.branch.empty() ? branch : ours.branch);
    }
}

/// Redo goes where it went, though there are newer children now.
void Journal::keepRedo(Step& step, const History& history, const TakenIn& taken)
{
    for (const History::Node& node : taken.nodes) {
        if (node.parent >= history.count())
            continue;
        const NodeId next = history.node(node.parent).lastVisitedChild;
        if (next < 0)
            continue;
        step.redo[node.parent] = next;
        step.rows.put("redo", {Value::integer(node.parent), Value::integer(next)});
    }
}

} // namespace bolster
