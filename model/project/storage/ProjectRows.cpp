#include "ProjectRows.h"

#include "DesignHash.h"
#include "EditCodec.h"

#include <QDateTime>
#include <QUuid>

namespace bolster {

NewNode firstNode(const Design& design)
{
    return {0,
            newUid(),
            -1,
            QDateTime::currentMSecsSinceEpoch(),
            0,
            {},
            packChanges(fieldChanges(editBetween(Design(), design, {}))),
            hashOf(design)};
}

Hash putNode(SealedRows& rows, const NewNode& node, const Hash& chain)
{
    const std::string args = encodeTexts(node.verb.args);
    return rows.put("node",
                    {Value::integer(node.id), Value::blob(node.uid),
                     node.parent < 0 ? Value::null() : Value::integer(node.parent), Value::integer(node.at),
                     Value::integer(node.run), Value::text(node.verb.key), Value::blob(args),
                     Value::blob(node.patch), Value::blob(bytesOf(node.designHash))},
                    chain);
}

void putProject(SealedRows& rows, const std::string& uuid, const std::optional<Hash>& base)
{
    rows.put("project", {Value::integer(0), Value::blob(uuid), Value::text(BOLSTER_VERSION),
                         base ? Value::blob(bytesOf(*base)) : Value::null()});
}

void putSnapshot(SealedRows& rows, NodeId node, const Design& design)
{
    if (const std::string data = encodeDesign(design); !data.empty())
        rows.put("snapshot", {Value::integer(node), Value::integer(1), Value::blob(data)});
}

void putSavePoint(Database& database, SealedRows& rows, NodeId node)
{
    rows.put("save_point", {Value::integer(database.number("SELECT coalesce(max(id), 0) + 1 FROM save_point")),
                            Value::integer(QDateTime::currentMSecsSinceEpoch()), Value::integer(node)});
}

void putLabel(SealedRows& rows, NodeId node, const std::string& version, const std::string& branch)
{
    const auto named = [](const std::string& name) { return name.empty() ? Value::null() : Value::text(name); };
    if (version.empty() && branch.empty())
        rows.erase("label", node);
    else
        rows.put("label", {Value::integer(node), named(version), named(branch), Value::integer(0)});
}

void putAsset(Database& database, SealedRows& rows, const std::string& name, std::int64_t blob)
{
    rows.put("asset", {Value::integer(database.number("SELECT coalesce(max(id), 0) + 1 FROM asset")),
                       Value::text(name), Value::integer(blob)});
}

std::string newUid()
{
    return QUuid::createUuid().toRfc4122().toStdString();
}

void prepareUnshared(Database& database)
{
    database.run("PRAGMA page_size = 8192");
    database.run("PRAGMA locking_mode = EXCLUSIVE");
    database.run("PRAGMA journal_mode = DELETE"); // the form at rest
    database.run("PRAGMA journal_mode = MEMORY");
    database.run("PRAGMA synchronous = OFF");
}

} // namespace bolster
