// Project files whose hashes are all right, and that say what nobody would make.
#pragma once

#include "DesignHash.h"
#include "EditCodec.h"
#include "ProjectRows.h"
#include "Schema.h"

#include <QFile>

namespace bolster::test {

class CraftedProject {
public:
    explicit CraftedProject(const QString& path)
        : m_database(path, Database::Access::Working)
        , m_rows(m_database, {})
    {
        prepareUnshared(m_database);
        createTables(m_database);
        putProject(m_rows, newUid(), std::nullopt);
    }
    ~CraftedProject() { m_rows.close(m_current); }
    CraftedProject(const CraftedProject&) = delete;
    CraftedProject& operator=(const CraftedProject&) = delete;

    NodeId node(NodeId parent, const std::string& patch, const Hash& designHash, const Message& verb = {"Edit"})
    {
        const auto id = static_cast<NodeId>(m_hashes.size());
        const Hash chain = parent < 0 ? Hash{} : m_hashes[static_cast<std::size_t>(parent)];
        m_hashes.push_back(
            putNode(m_rows, {id, newUid(), parent, 1'700'000'000'000 + id, 1, verb, patch, designHash}, chain));
        return m_current = id;
    }
    NodeId node(NodeId parent, const Design& from, const Design& to, const Message& verb = {"Edit"})
    {
        return node(parent, packChanges(fieldChanges(editBetween(from, to, {}))), hashOf(to), verb);
    }
    void snapshot(NodeId node, const std::string& data)
    {
        m_rows.put("snapshot", {Value::integer(node), Value::integer(1), Value::blob(data)});
    }
    /// A content of a few bytes.
    void asset(std::int64_t id, const std::string& name, std::int64_t blob, const std::string& bytes)
    {
        if (m_blobs.insert(blob).second) {
            const Hash hash = hashOf(std::string_view(bytes));
            m_rows.put("blob", {Value::integer(blob), Value::blob(bytesOf(hash)),
                                Value::integer(static_cast<std::int64_t>(bytes.size()))});
        }
        m_rows.put("asset", {Value::integer(id), Value::text(name), Value::integer(blob)});
    }
    void run(const char* sql) { m_database.run(sql); }
    void stand(NodeId node) { m_current = node; }

private:
    Database m_database;
    SealedRows m_rows;
    std::vector<Hash> m_hashes;
    std::set<std::int64_t> m_blobs;
    NodeId m_current = 0;
};

/// As edits are packed; `level` 9 for what shall be as small as can be, which takes its time.
inline std::string packed(const std::string& bytes, int level = 9)
{
    return qCompress(reinterpret_cast<const uchar*>(bytes.data()), static_cast<qsizetype>(bytes.size()), level)
        .toStdString();
}

/// A list of so many things in CBOR, which follow.
inline std::string cborList(std::uint32_t count)
{
    std::string bytes = "\x9a";
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(count >> shift);
    return bytes;
}

/// [element, "", null, text] for elements from 1 on.
inline std::string cborOfNewElements(std::uint32_t count, const std::string& text)
{
    std::string bytes = cborList(count);
    for (std::uint32_t id = 1; id <= count; ++id) {
        bytes += "\x84\x1a";
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes += static_cast<char>(id >> shift);
        bytes += "\x60\xf6\x79"; // "", null, a text with two bytes for its length
        bytes += static_cast<char>(text.size() >> 8);
        bytes += static_cast<char>(text.size());
        bytes += text;
    }
    return bytes;
}

} // namespace bolster::test
