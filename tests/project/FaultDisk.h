// A disk for SQLite that loses its power, or fails, at a chosen call.
#pragma once

#include <sqlite3.h>

#include <map>
#include <mutex>
#include <random>
#include <string>
#include <vector>

namespace bolster::test {

/// Files in memory, used through the VFS with the name given. What was written since the last sync of a file is
/// only in a cache: a power cut keeps any part of it, in any order, in sectors of 512 bytes. Threads may share it.
class FaultDisk {
public:
    explicit FaultDisk(const char* name);
    ~FaultDisk();
    FaultDisk(const FaultDisk&) = delete;
    FaultDisk& operator=(const FaultDisk&) = delete;

    /// Calls that read, write, sync, open, delete or ask for a size are counted. Call number `at` fails with this
    /// code, and all later ones if `lasting`.
    void failAt(int at, int code, bool lasting);
    void heal() { m_failAt = -1; }
    bool failed() const;
    /// After it each file holds what reached the disk. Nobody may have files open.
    void powerCut(std::mt19937& random);

private:
    struct Piece { // of a write: within a sector
        std::size_t offset;
        std::string bytes;
    };
    struct File {
        std::string now;
        std::string synced;
        std::vector<Piece> since; // written after the last sync
        bool durable = false;     // its name is on the disk
        bool deleted = false;     // the name is gone, perhaps not on the disk yet
    };
    struct Handle;
    struct Methods;

    int count(); // an error code, or SQLITE_OK

    sqlite3_vfs m_vfs = {};
    mutable std::recursive_mutex m_turn; // of threads
    std::map<std::string, File> m_files;
    int m_calls = 0;
    int m_failAt = -1;
    int m_code = SQLITE_IOERR;
    bool m_lasting = false;
    bool m_failed = false;
};

} // namespace bolster::test
