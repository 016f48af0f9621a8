#include "FaultDisk.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace bolster::test {
namespace {

constexpr std::size_t sector = 512;

} // namespace

struct FaultDisk::Handle {
    sqlite3_file base;
    FaultDisk* disk;
    File* file;
};

// What SQLite calls.
struct FaultDisk::Methods {
    static Handle& handle(sqlite3_file* file) { return *reinterpret_cast<Handle*>(file); }
    static FaultDisk& disk(sqlite3_vfs* vfs) { return *static_cast<FaultDisk*>(vfs->pAppData); }

    static int close(sqlite3_file*) { return SQLITE_OK; }

    static int read(sqlite3_file* file, void* target, int amount, sqlite3_int64 offset)
    {
        const std::scoped_lock turn(handle(file).disk->m_turn);
        if (const int code = handle(file).disk->count())
            return code;
        const std::string& bytes = handle(file).file->now;
        const auto begin = std::min(static_cast<std::size_t>(offset), bytes.size());
        const auto got = std::min(static_cast<std::size_t>(amount), bytes.size() - begin);
        std::memcpy(target, bytes.data() + begin, got);
        std::memset(static_cast<char*>(target) + got, 0, static_cast<std::size_t>(amount) - got);
        return got == static_cast<std::size_t>(amount) ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
    }

    static int write(sqlite3_file* file, const void* source, int amount, sqlite3_int64 offset)
    {
        const std::scoped_lock turn(handle(file).disk->m_turn);
        const int code = handle(file).disk->count();
        if (code && code != SQLITE_FULL)
            return code;
        File& to = *handle(file).file;
        std::string_view bytes(static_cast<const char*>(source), static_cast<std::size_t>(amount));
        if (code == SQLITE_FULL)
            bytes = bytes.substr(0, bytes.size() / 2); // the disk took as much as it could
        auto at = static_cast<std::size_t>(offset);
        if (to.now.size() < at + bytes.size())
            to.now.resize(at + bytes.size());
        to.now.replace(at, bytes.size(), bytes);
        while (!bytes.empty()) {
            const std::size_t size = std::min(bytes.size(), sector - at % sector);
            to.since.push_back({at, std::string(bytes.substr(0, size))});
            at += size;
            bytes.remove_prefix(size);
        }
        return code;
    }

    static int truncate(sqlite3_file* file, sqlite3_int64 size)
    {
        const std::scoped_lock turn(handle(file).disk->m_turn);
        if (const int code = handle(file).disk->count())
            return code;
        handle(file).file->now.resize(static_cast<std::size_t>(size));
        return SQLITE_OK;
    }

    static int sync(sqlite3_file* file, int)
    {
        const std::scoped_lock turn(handle(file).disk->m_turn);
        if (const int code = handle(file).disk->count())
            return code;
        File& synced = *handle(file).file;
        synced.synced = synced.now;
        synced.since.clear();
        synced.durable = true;
        return SQLITE_OK;
    }

    static int size(sqlite3_file* file, sqlite3_int64* size)
    {
        const std::scoped_lock turn(handle(file).disk->m_turn);
        *size = static_cast<sqlite3_int64>(handle(file).file->now.size());
        return handle(file).disk->count();
    }

    static int lock(sqlite3_file*, int) { return SQLITE_OK; }
    static int isReserved(sqlite3_file*, int* result)
    {
        *result = 0;
        return SQLITE_OK;
    }
    static int control(sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; }
    static int sectorSize(sqlite3_file*) { return sector; }
    static int characteristics(sqlite3_file*) { return SQLITE_IOCAP_POWERSAFE_OVERWRITE; } // as Linux says

    static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* outFlags)
    {
        const std::scoped_lock turn(disk(vfs).m_turn);
        static const sqlite3_io_methods methods = {
            1,       close,      read,    write,      truncate,        sync,    size,    lock,
            lock,    isReserved, control, sectorSize, characteristics, nullptr, nullptr, nullptr,
            nullptr, nullptr,    nullptr};
        file->pMethods = nullptr;
        if (const int code = disk(vfs).count())
            return code == SQLITE_FULL ? SQLITE_CANTOPEN : code;
        auto& files = disk(vfs).m_files;
        const std::string key = name ? name : "temporary";
        if (!(flags & SQLITE_OPEN_CREATE) && (!files.contains(key) || files[key].deleted))
            return SQLITE_CANTOPEN;
        File& opened = files[key];
        if (opened.deleted) {
            opened.now.clear();
            opened.since.clear();
            opened.deleted = false;
        }
        handle(file) = {{&methods}, &disk(vfs), &opened};
        if (outFlags)
            *outFlags = flags;
        return SQLITE_OK;
    }

    static int remove(sqlite3_vfs* vfs, const char* name, int sync)
    {
        const std::scoped_lock turn(disk(vfs).m_turn);
        if (const int code = disk(vfs).count())
            return code;
        const auto found = disk(vfs).m_files.find(name);
        if (found == disk(vfs).m_files.end() || found->second.deleted)
            return SQLITE_IOERR_DELETE_NOENT;
        found->second.deleted = true;
        if (sync)
            disk(vfs).m_files.erase(found);
        return SQLITE_OK;
    }

    static int access(sqlite3_vfs* vfs, const char* name, int, int* result)
    {
        const std::scoped_lock turn(disk(vfs).m_turn);
        const auto found = disk(vfs).m_files.find(name);
        *result = found != disk(vfs).m_files.end() && !found->second.deleted;
        return disk(vfs).count();
    }

    static int fullPath(sqlite3_vfs*, const char* name, int size, char* target)
    {
        sqlite3_snprintf(size, target, "%s", name);
        return SQLITE_OK;
    }

    static int randomness(sqlite3_vfs*, int size, char* target)
    {
        sqlite3_vfs* const real = sqlite3_vfs_find(nullptr);
        return real->xRandomness(real, size, target);
    }
    static int sleep(sqlite3_vfs*, int) { return 0; }
    static int time(sqlite3_vfs*, double* now)
    {
        *now = 2'460'000.5;
        return SQLITE_OK;
    }
    static int lastError(sqlite3_vfs*, int, char*) { return 0; }
};

FaultDisk::FaultDisk(const char* name)
{
    m_vfs.iVersion = 1;
    m_vfs.szOsFile = sizeof(Handle);
    m_vfs.mxPathname = 512;
    m_vfs.zName = name;
    m_vfs.pAppData = this;
    m_vfs.xOpen = Methods::open;
    m_vfs.xDelete = Methods::remove;
    m_vfs.xAccess = Methods::access;
    m_vfs.xFullPathname = Methods::fullPath;
    m_vfs.xRandomness = Methods::randomness;
    m_vfs.xSleep = Methods::sleep;
    m_vfs.xCurrentTime = Methods::time;
    m_vfs.xGetLastError = Methods::lastError;
    sqlite3_vfs_register(&m_vfs, 0);
}

FaultDisk::~FaultDisk()
{
    sqlite3_vfs_unregister(&m_vfs);
}

void FaultDisk::failAt(int at, int code, bool lasting)
{
    const std::scoped_lock turn(m_turn);
    m_calls = 0;
    m_failed = false;
    m_failAt = at;
    m_code = code;
    m_lasting = lasting;
}

bool FaultDisk::failed() const
{
    const std::scoped_lock turn(m_turn);
    return m_failed;
}

int FaultDisk::count()
{
    const int call = m_calls++;
    const bool fails = m_failAt >= 0 && (m_lasting ? call >= m_failAt : call == m_failAt);
    m_failed = m_failed || fails;
    return fails ? m_code : SQLITE_OK;
}

void FaultDisk::powerCut(std::mt19937& random)
{
    const unsigned keptOfTen = random() % 11;
    for (auto entry = m_files.begin(); entry != m_files.end();) {
        File& file = entry->second;
        const bool nameKept = file.deleted ? random() % 2 == 0 : file.durable || random() % 2 == 0;
        if (!nameKept) {
            entry = m_files.erase(entry);
            continue;
        }
        std::shuffle(file.since.begin(), file.since.end(), random);
        for (const Piece& piece : file.since) {
            if (random() % 10 >= keptOfTen)
                continue;
            if (file.synced.size() < piece.offset + piece.bytes.size())
                file.synced.resize(piece.offset + piece.bytes.size());
            file.synced.replace(piece.offset, piece.bytes.size(), piece.bytes);
        }
        if (file.now.size() < file.synced.size() && random() % 2 == 0) // it was cut short: perhaps not on the disk
            file.synced.resize(file.now.size());
        file = {file.synced, file.synced, {}, true, false};
        ++entry;
    }
}

} // namespace bolster::test
