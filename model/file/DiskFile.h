// A file that is read a piece at a time.
#pragma once

#include "Message.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <utility>

namespace bolster {

class DiskFile {
public:
    /// Nothing, and a problem in the user's words, unless it is a regular file of at most `largest` bytes.
    static std::optional<DiskFile> open(const QString& path, std::int64_t largest, Message& problem);

    DiskFile(DiskFile&& other) noexcept
        : m_fd(std::exchange(other.m_fd, -1))
        , m_size(other.m_size)
    {}
    DiskFile& operator=(DiskFile&&) = delete;
    ~DiskFile();

    std::uint64_t size() const { return m_size; } ///< bytes, when it was opened
    int descriptor() const { return m_fd; }       ///< for a process that is to have this file and no other
    /// Reads `count` bytes from `at` on; fewer at the end. Returns how many, or -1 with errno set. Threads may do
    /// so at the same time.
    std::int64_t read(std::uint64_t at, char* to, std::size_t count) const;

private:
    DiskFile(int fd, std::uint64_t size)
        : m_fd(fd)
        , m_size(size)
    {}

    int m_fd;
    std::uint64_t m_size;
};

/// Why a file cannot be read: a pipe that nobody writes to would keep its reader for ever. Empty for an ordinary
/// one.
Message ordinaryFileProblem(const QString& path);

/// "you are not allowed to read ..." and so on, for an error number.
Message readProblem(const QString& path, int error);

} // namespace bolster
