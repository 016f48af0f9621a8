#include "SchemaRepair.h"

#include "Schema.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace bolster {

namespace {

constexpr qsizetype headSize = 100;   // of the file, before the list
constexpr qsizetype treeHeadSize = 8; // of a leaf: its kind, gaps, the number and start of its cells
constexpr char leafOfATable = 0x0D;
constexpr qsizetype mostPageBytes = 4; // of the number of a table's first page

struct Table {
    QByteArray words; ///< kind, name and name again, as they stand before the page's number
    QByteArray name;
    QByteArray sql;
    std::uint32_t firstPage = 0;
};

/// In how many bytes they differ.
qsizetype difference(const QByteArray& page, qsizetype at, const QByteArray& text)
{
    qsizetype count = 0;
    for (qsizetype i = 0; i < text.size(); ++i)
        count += page[at + i] != text[i];
    return count;
}

/// Where the text stands, with at most one wrong byte in eight.
std::optional<qsizetype> placeOf(const QByteArray& text, const QByteArray& page)
{
    std::optional<qsizetype> place;
    qsizetype best = text.size() / 8 + 1;
    for (qsizetype at = headSize + treeHeadSize; at + text.size() <= page.size(); ++at)
        if (const qsizetype wrong = difference(page, at, text); wrong < best) {
            best = wrong;
            place = at;
        }
    return place;
}

/// The number of its first page stands between its names and its statement.
std::optional<Table> found(const char* statement, const QByteArray& page)
{
    Table table;
    table.sql = statement;
    table.name = QByteArray::fromStdString(tableName(statement));
    table.words = "table" + table.name + table.name;
    const std::optional<qsizetype> sql = placeOf(table.sql, page);
    if (!sql)
        return std::nullopt;
    qsizetype length = 0, best = table.words.size() / 4 + 1;
    for (qsizetype bytes = 1; bytes <= mostPageBytes; ++bytes) {
        const qsizetype at = *sql - bytes - table.words.size();
        if (at < headSize)
            break;
        if (const qsizetype wrong = difference(page, at, table.words); wrong < best) {
            best = wrong;
            length = bytes;
        }
    }
    if (length == 0)
        return std::nullopt;
    for (qsizetype i = *sql - length; i < *sql; ++i)
        table.firstPage = table.firstPage << 8 | static_cast<unsigned char>(page[i]);
    return table;
}

/// SQLite's numbers of variable length, as far as they are needed here.
QByteArray variable(qsizetype number)
{
    QByteArray bytes;
    if (number >= 128)
        bytes.append(static_cast<char>(0x80 | number >> 7));
    bytes.append(static_cast<char>(number & 0x7F));
    return bytes;
}

/// A row of the list: kind, name, name of the table, first page, statement.
QByteArray cellOf(const Table& table, int row)
{
    const auto text = [](const QByteArray& value) { return variable(13 + 2 * value.size()); };
    constexpr char wholeNumberOf4Bytes = 4;
    QByteArray types = text("table") + text(table.name) + text(table.name);
    types.append(wholeNumberOf4Bytes);
    types += text(table.sql);
    QByteArray number;
    for (int shift = 24; shift >= 0; shift -= 8)
        number.append(static_cast<char>(table.firstPage >> shift));
    const QByteArray record = variable(types.size() + 1) + types + table.words + number + table.sql;
    return variable(record.size()) + variable(row) + record;
}

QByteArray madeAnew(const QByteArray& page, const std::vector<Table>& tables)
{
    QByteArray result = page.first(headSize) + QByteArray(page.size() - headSize, '\0');
    const auto put = [&](qsizetype at, qsizetype number) {
        result[at] = static_cast<char>(number >> 8);
        result[at + 1] = static_cast<char>(number);
    };
    qsizetype start = result.size();
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const QByteArray cell = cellOf(tables[i], static_cast<int>(i) + 1);
        start -= cell.size();
        result.replace(start, cell.size(), cell);
        put(headSize + treeHeadSize + 2 * static_cast<qsizetype>(i), start);
    }
    result[headSize] = leafOfATable;
    put(headSize + 3, static_cast<qsizetype>(tables.size()));
    put(headSize + 5, start);
    return result;
}

} // namespace

QByteArray withRepairedSchema(const QByteArray& page)
{
    std::vector<Table> tables;
    bool sound =
        tablesFitOnePage({page.constData() + headSize, static_cast<std::size_t>(page.size() - headSize)}, 0);
    for (const char* statement : tableStatements()) {
        const std::optional<Table> table = found(statement, page);
        sound = sound && table && page.contains(table->words) && page.contains(table->sql);
        if (table)
            tables.push_back(*table);
    }
    return sound || tables.empty() ? page : madeAnew(page, tables);
}

} // namespace bolster
