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
constexpr qsizetype mostWrong = 6;     // bytes of the words of a table: more are another table

struct Table {
    QByteArray words; ///< kind, name and name again, as they stand before the page's number
    QByteArray name;
    QByteArray sql;
    std::uint32_t firstPage = 0;
    qsizetype pageBytes = mostPageBytes; ///< in which that number is written
    qsizetype at = 0;                    ///< where the words stand
};

/// In how many bytes they differ.
qsizetype difference(const QByteArray& page, qsizetype at, const QByteArray& text)
{
    qsizetype count = 0;
    for (qsizetype i = 0; i < text.size(); ++i)
        count += page[at + i] != text[i];
    return count;
}

/// Where the text stands, with few wrong bytes.
std::optional<qsizetype> placeOf(const QByteArray& text, const QByteArray& page)
{
    std::optional<qsizetype> place;
    qsizetype best = mostWrong + 1;
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
    qsizetype length = 0, best = mostWrong + 1;
    for (qsizetype bytes = 1; bytes <= mostPageBytes; ++bytes) {
        const qsizetype at = *sql - bytes - table.words.size();
        if (at < headSize)
            break;
        if (const qsizetype wrong = difference(page, at, table.words); wrong < best) {
            best = wrong;
            length = bytes;
            table.at = at;
        }
    }
    if (length == 0)
        return std::nullopt;
    table.pageBytes = length;
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

/// What stands before the words of a row: how long it is, its number, the types of kind, names, first page and
/// statement.
QByteArray cellHead(const Table& table, int row)
{
    const auto text = [](const QByteArray& value) { return variable(13 + 2 * value.size()); };
    QByteArray types = text("table") + text(table.name) + text(table.name);
    types.append(static_cast<char>(table.pageBytes)); // 1 to 4: a whole number of so many bytes
    types += text(table.sql);
    const QByteArray head = variable(types.size() + 1) + types;
    const qsizetype size = head.size() + table.words.size() + table.pageBytes + table.sql.size();
    return variable(size) + variable(row) + head;
}

QByteArray cellOf(const Table& table, int row)
{
    QByteArray number;
    for (qsizetype shift = 8 * (table.pageBytes - 1); shift >= 0; shift -= 8)
        number.append(static_cast<char>(table.firstPage >> shift));
    return cellHead(table, row) + table.words + number + table.sql;
}

/// Whether the list has this row, to the letter.
bool isListed(const Table& table, const QByteArray& page)
{
    constexpr int mostRows = 127;
    for (int row = 1; row <= mostRows; ++row) {
        const QByteArray cell = cellOf(table, row);
        const qsizetype start = table.at - cellHead(table, row).size();
        if (page.mid(start, cell.size()) != cell)
            continue;
        QByteArray pointer;
        pointer.append(static_cast<char>(start >> 8)).append(static_cast<char>(start));
        const qsizetype count = static_cast<unsigned char>(page[headSize + 4]);
        for (qsizetype i = 0; i < count; ++i)
            if (page.mid(headSize + treeHeadSize + 2 * i, 2) == pointer)
                return true;
    }
    return false;
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
        sound = sound && table && isListed(*table, page);
        if (table)
            tables.push_back(*table);
    }
    return sound || tables.empty() ? page : madeAnew(page, tables);
}

} // namespace bolster
