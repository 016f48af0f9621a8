// What the functions on whole files share. Private to the library.
#pragma once

#include "Message.h"

#include <QFile>
#include <QString>

#include <fcntl.h>
#include <optional>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace bolster {

/// An open file of the operating system.
class Descriptor {
public:
    Descriptor() = default;
    Descriptor(const QString& path, int flags, mode_t mode = 0)
        : m_fd(::open(QFile::encodeName(path).constData(), flags | O_CLOEXEC, mode))
    {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept
        : m_fd(std::exchange(other.m_fd, -1))
    {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(m_fd, other.m_fd);
        return *this;
    }

    bool valid() const { return m_fd >= 0; }
    int get() const { return m_fd; }
    bool close() { return m_fd < 0 || ::close(std::exchange(m_fd, -1)) == 0; }

private:
    int m_fd = -1;
};

std::optional<struct stat> statusOf(const QString& path);
std::optional<struct stat> statusOf(const Descriptor& file);

/// 0 or an error number.
int writeAll(const Descriptor& file, std::string_view bytes);
/// The same; file systems that cannot do it are none.
int syncFolder(const QString& folder);

/// In the user's words.
Message writeProblem(const QString& path, int error);
/// Why a file that is there must not be replaced.
Message protection(const QString& path, const struct stat& present);

} // namespace bolster
