#include "Database.h"

#include <QFileInfo>
#include <QScopeGuard>
#include <QUrl>

#include <sqlite3.h>

#include <algorithm>
#include <utility>

namespace bolster {
namespace {

constexpr std::int64_t largestValue = 256 << 20; // bytes of a column
constexpr std::int64_t smallestLimit = 1 << 20;
constexpr std::int64_t stepsPerByte = 10;
constexpr std::int64_t stepsAtLeast = 10'000'000;
constexpr int stepsAtOnce = 10'000;
constexpr int pagesInLog = 1'000; // before what is in it goes to the file

Message sentence(int code, const std::string& path, const char* words)
{
    switch (code & 0xff) {
    case SQLITE_FULL:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: the disk is full; make room or choose "
                                             "another folder"),
                {path}};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is write-protected"), {path}};
    case SQLITE_CANTOPEN:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be opened or made"), {path}};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is in use by another program"), {path}};
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_FORMAT:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged (%2)"), {path, words}};
    default:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be read or written (%2)"), {path, words}};
    }
}

/// Only in an address can it be said that a journal beside the file is none of SQLite's business, and which disk.
QByteArray addressOf(const QString& path)
{
    return "file:" + QUrl::toPercentEncoding(path, "/");
}

[[noreturn]] void wrongKind(const Database& database)
{
    throw DatabaseError(
        {QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged: a row holds something of another kind than it should"),
         {database.name().toStdString()}});
}

Value::Type typeOf(const Database& database, int sqlType)
{
    switch (sqlType) {
    case SQLITE_NULL:
        return Value::Type::Null;
    case SQLITE_INTEGER:
        return Value::Type::Integer;
    case SQLITE_TEXT:
        return Value::Type::Text;
    case SQLITE_BLOB:
        return Value::Type::Blob;
    default:
        wrongKind(database);
    }
}

} // namespace

Query::Query(Database& database, const char* sql, std::initializer_list<Value> values)
    : m_database(database)
    , m_turn(database)
    , m_statement(database.prepared(sql))
{
    for (const Value& value : values)
        bind(value);
}

Query::Query(Database& database, const char* sql, std::span<const Value> values, const Value& last)
    : m_database(database)
    , m_turn(database)
    , m_statement(database.prepared(sql))
{
    for (const Value& value : values)
        bind(value);
    bind(last);
}

void Query::bind(const Value& value)
{
    ++m_bound;
    const auto size = static_cast<sqlite3_uint64>(value.bytes.size());
    const char* const bytes = value.bytes.data() ? value.bytes.data() : ""; // null would bind NULL
    int code = SQLITE_OK;
    if (value.type == Value::Type::Integer)
        code = sqlite3_bind_int64(m_statement, m_bound, value.number);
    else if (value.type == Value::Type::Text)
        code = sqlite3_bind_text64(m_statement, m_bound, bytes, size, SQLITE_STATIC, SQLITE_UTF8);
    else if (value.type == Value::Type::Blob)
        code = sqlite3_bind_blob64(m_statement, m_bound, bytes, size, SQLITE_STATIC);
    else
        code = sqlite3_bind_null(m_statement, m_bound);
    if (code != SQLITE_OK)
        m_database.fail(code);
}

Query::~Query()
{
    sqlite3_reset(m_statement);
    sqlite3_clear_bindings(m_statement);
}

bool Query::next()
{
    const int code = sqlite3_step(m_statement);
    if (code != SQLITE_ROW && code != SQLITE_DONE)
        m_database.fail(code);
    return code == SQLITE_ROW;
}

void Query::run()
{
    while (next()) {
    }
}

int Query::columns() const
{
    return sqlite3_column_count(m_statement);
}

Value Query::value(int column) const
{
    const Value::Type type = typeOf(m_database, sqlite3_column_type(m_statement, column));
    if (type == Value::Type::Null)
        return Value::null();
    if (type == Value::Type::Integer)
        return Value::integer(sqlite3_column_int64(m_statement, column));
    const auto* bytes = type == Value::Type::Text
                            ? reinterpret_cast<const char*>(sqlite3_column_text(m_statement, column))
                            : static_cast<const char*>(sqlite3_column_blob(m_statement, column));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(m_statement, column));
    if (!bytes && size > 0)
        throw std::bad_alloc();
    return {type, 0, bytes ? std::string_view(bytes, size) : std::string_view()};
}

std::int64_t Query::integer(int column) const
{
    const Value found = value(column);
    if (found.type != Value::Type::Integer)
        wrongKind(m_database);
    return found.number;
}

std::string_view Query::text(int column) const
{
    const Value found = value(column);
    if (found.type != Value::Type::Text)
        wrongKind(m_database);
    return found.bytes;
}

std::string_view Query::blob(int column) const
{
    const Value found = value(column);
    if (found.type != Value::Type::Blob)
        wrongKind(m_database);
    return found.bytes;
}

Database::Database(const QString& path, Access access, const char* vfs)
    : m_path(path)
    , m_vfs(vfs)
{
    QByteArray address = addressOf(path);
    int flags = SQLITE_OPEN_URI | SQLITE_OPEN_EXRESCODE;
    if (access == Access::AtRest) {
        address += "?immutable=1";
        flags |= SQLITE_OPEN_READONLY;
        m_stepsLeft = stepsAtLeast + stepsPerByte * QFileInfo(path).size();
    } else {
        flags |= SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    }
    const int code = sqlite3_open_v2(address.constData(), &m_handle, flags, vfs);
    try {
        if (code != SQLITE_OK)
            fail(code);
        harden(access);
    } catch (...) {
        close();
        throw;
    }
}

Database::~Database()
{
    close();
}

void Database::close()
{
    const std::scoped_lock turn(*this);
    for (const auto& [sql, statement] : m_statements)
        sqlite3_finalize(statement);
    m_statements.clear();
    sqlite3_close(std::exchange(m_handle, nullptr));
}

void Database::harden(Access access)
{
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
    // A file at rest may claim values that are longer than itself, with pages that follow each other in circles.
    const std::int64_t most =
        access == Access::AtRest ? std::max<std::int64_t>(QFileInfo(m_path).size(), smallestLimit) : largestValue;
    sqlite3_limit(m_handle, SQLITE_LIMIT_LENGTH, static_cast<int>(std::min(most, largestValue)));
    sqlite3_limit(m_handle, SQLITE_LIMIT_SQL_LENGTH, 10'000);
    sqlite3_limit(m_handle, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_extended_result_codes(m_handle, 1);
    if (access == Access::AtRest)
        sqlite3_progress_handler(
            m_handle, stepsAtOnce,
            [](void* self) {
                auto* const database = static_cast<Database*>(self);
                database->m_stepsLeft -= stepsAtOnce;
                return database->m_stepsLeft < 0 ? 1 : 0;
            },
            this);
    run("PRAGMA mmap_size = 0");
    run("PRAGMA cell_size_check = ON");
}

std::int64_t Database::number(const char* sql)
{
    Query query(*this, sql);
    return query.next() ? query.integer(0) : 0;
}

std::unique_ptr<Database> Database::freeze()
{
    const std::scoped_lock turn(*this);
    sqlite3_wal_autocheckpoint(m_handle, 0);
    try {
        Query checkpoint(*this, "PRAGMA wal_checkpoint(TRUNCATE)");
        if (!checkpoint.next() || checkpoint.integer(0) != 0)
            fail(SQLITE_BUSY);
        return std::make_unique<Database>(m_path, Access::AtRest, m_vfs);
    } catch (...) {
        thaw();
        throw;
    }
}

void Database::thaw()
{
    sqlite3_wal_autocheckpoint(m_handle, pagesInLog);
}

void Database::vacuumInto(const QString& path)
{
    const QByteArray address = addressOf(path) + "?vfs=" + sqlite3_vfs_find(nullptr)->zName;
    m_target = path;
    const auto done = qScopeGuard([this] { m_target.clear(); });
    runVacuum("VACUUM INTO ?", {Value::text({address.constData(), static_cast<std::size_t>(address.size())})});
}

void Database::vacuum()
{
    runVacuum("VACUUM", {});
}

/// The new file is attached while it is written.
void Database::runVacuum(const char* sql, std::initializer_list<Value> values)
{
    sqlite3_limit(m_handle, SQLITE_LIMIT_ATTACHED, 1);
    try {
        run(sql, values);
    } catch (...) {
        sqlite3_limit(m_handle, SQLITE_LIMIT_ATTACHED, 0);
        throw;
    }
    sqlite3_limit(m_handle, SQLITE_LIMIT_ATTACHED, 0);
}

sqlite3_stmt* Database::prepared(const char* sql)
{
    if (!m_handle)
        throw DatabaseError({QT_TRANSLATE_NOOP("Message", "\"%1\" is closed"), {name().toStdString()}});
    if (const auto known = m_statements.find(sql); known != m_statements.end())
        return known->second;
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v3(m_handle, sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
    if (code != SQLITE_OK)
        fail(code);
    m_statements.emplace(sql, statement);
    return statement;
}

void Database::fail(int code) const
{
    if ((code & 0xff) == SQLITE_NOMEM)
        throw std::bad_alloc();
    const int kind = code & 0xff; // SQLite says no file; what is damaged is what is read
    const bool reading = m_target.isEmpty() || kind == SQLITE_CORRUPT || kind == SQLITE_NOTADB;
    throw DatabaseError(sentence(code, (reading ? name() : m_target).toStdString(), sqlite3_errmsg(m_handle)));
}

Transaction::Transaction(Database& database)
    : m_database(database)
    , m_turn(database)
{
    m_database.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction()
{
    if (!m_open)
        return;
    try {
        m_database.run("ROLLBACK");
    } catch (const std::exception&) { // an error has rolled it back already
    }
}

void Transaction::commit()
{
    m_database.run("COMMIT");
    m_open = false;
}

} // namespace bolster
