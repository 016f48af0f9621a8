// SQLite, hardened against files from anybody. Private to the library.
#pragma once

#include "Message.h"

#include <QString>

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace bolster {

/// What the public functions of the library make a problem of.
struct DatabaseError : std::runtime_error {
    explicit DatabaseError(Message why)
        : std::runtime_error(why.english())
        , message(std::move(why))
    {}
    Message message;
};

/// A value of a column; its bytes live elsewhere.
struct Value {
    enum class Type : std::uint8_t { Null, Integer, Text, Blob };

    static Value null() { return {}; }
    static Value integer(std::int64_t number) { return {Type::Integer, number, {}}; }
    static Value text(std::string_view text) { return {Type::Text, 0, text}; }
    static Value blob(std::string_view bytes) { return {Type::Blob, 0, bytes}; }

    Type type = Type::Null;
    std::int64_t number = 0;
    std::string_view bytes = {};
};

class Database;

/// A statement of a database, made once and used again. It is reset when the use ends; until then other threads
/// wait for the database.
class Query {
public:
    /// Takes the values in the order of the question marks.
    Query(Database& database, const char* sql, std::initializer_list<Value> values = {});
    Query(Database& database, const char* sql, std::span<const Value> values, const Value& last);
    ~Query();
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;

    /// The next row, if there is one.
    bool next();
    void run();

    int columns() const;
    /// Valid until the next row.
    Value value(int column) const;
    /// These throw when the column holds something else.
    std::int64_t integer(int column) const;
    std::string_view text(int column) const;
    std::string_view blob(int column) const;

private:
    void bind(const Value& value);

    Database& m_database;
    std::unique_lock<Database> m_turn;
    sqlite3_stmt* m_statement;
    int m_bound = 0;
};

/// Everything here throws DatabaseError. Threads take turns.
class Database {
public:
    enum class Access {
        AtRest, ///< read only; the file is known not to change, whatever lies beside it is not looked at
        Working ///< read and write, made if it is not there
    };

    /// `vfs` is for tests that simulate disks.
    Database(const QString& path, Access access, const char* vfs = nullptr);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// For what belongs together: other threads wait between them. The one that has it may lock it again.
    void lock() { m_turn.lock(); }
    void unlock() { m_turn.unlock(); }
    /// Lets go of the file; whatever is asked for afterwards throws.
    void close();
    const QString& path() const { return m_path; }
    /// In sentences: the path, unless it is a copy of the file that the user knows.
    const QString& name() const { return m_name.isEmpty() ? m_path : m_name; }
    void setName(const QString& name) { m_name = name; }
    /// How large the file is, with what is in its log.
    std::int64_t bytes() { return number("PRAGMA page_count") * number("PRAGMA page_size"); }
    void run(const char* sql, std::initializer_list<Value> values = {}) { Query(*this, sql, values).run(); }
    std::int64_t number(const char* sql);
    /// Of one with a write-ahead log: brings all that was done into the file itself, which is left alone then until
    /// thaw(): what comes goes to the log. Returns a connection that sees the file as it is now, for another
    /// thread. There may be one at a time.
    std::unique_ptr<Database> freeze();
    void thaw();
    /// Writes all that is in here, without gaps, to a new file of the real disk; an empty one may be there.
    void vacuumInto(const QString& path);
    /// Gives back what was removed.
    void vacuum();

private:
    friend class Query;
    sqlite3_stmt* prepared(const char* sql);
    void harden(Access access);
    void runVacuum(const char* sql, std::initializer_list<Value> values);
    [[noreturn]] void fail(int code) const;

    std::recursive_mutex m_turn;
    QString m_path;
    QString m_name;
    QString m_target; // of what is being written to another file
    const char* m_vfs;
    sqlite3* m_handle = nullptr;
    std::map<std::string, sqlite3_stmt*, std::less<>> m_statements;
    std::int64_t m_stepsLeft = 0; // of the virtual machine, for files at rest: no file keeps us busy for ever
};

/// All or nothing: what is not committed is undone. Other threads wait until it ends.
class Transaction {
public:
    explicit Transaction(Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    void commit();

private:
    Database& m_database;
    std::unique_lock<Database> m_turn;
    bool m_open = true;
};

} // namespace bolster
