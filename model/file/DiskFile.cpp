#include "DiskFile.h"

#include <QFile>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>

namespace bolster {

Message readProblem(const QString& path, int error)
{
    const std::string name = path.toStdString();
    switch (error) {
    case ENOENT:
    case ENOTDIR:
        return {QT_TRANSLATE_NOOP("Message", "there is no file \"%1\""), {name}};
    case EACCES:
    case EPERM:
        return {QT_TRANSLATE_NOOP("Message", "you are not allowed to read \"%1\""), {name}};
    case EISDIR:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is a folder, not a file"), {name}};
    case EINVAL:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is not an ordinary file"), {name}};
    default:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be read (%2)"), {name, std::strerror(error)}};
    }
}

Message ordinaryFileProblem(const QString& path)
{
    Message problem;
    DiskFile::open(path, std::numeric_limits<std::int64_t>::max(), problem);
    return problem;
}

std::optional<DiskFile> DiskFile::open(const QString& path, std::int64_t largest, Message& problem)
{
    const int fd = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); // not for a pipe
    if (fd < 0) {
        problem = readProblem(path, errno);
        return std::nullopt;
    }
    DiskFile file(fd, 0);
    struct stat info = {};
    if (::fstat(fd, &info) != 0)
        problem = readProblem(path, errno);
    else if (!S_ISREG(info.st_mode))
        problem = readProblem(path, S_ISDIR(info.st_mode) ? EISDIR : EINVAL);
    else if (info.st_size > largest)
        problem = {
            QT_TRANSLATE_NOOP("Message", "\"%1\" is too large: %2 MB, and at most %3 MB are read"),
            {path.toStdString(), std::to_string(info.st_size / 1'000'000), std::to_string(largest / 1'000'000)}};
    if (!problem.empty())
        return std::nullopt;
    file.m_size = static_cast<std::uint64_t>(info.st_size);
    return file;
}

DiskFile::~DiskFile()
{
    if (m_fd >= 0)
        ::close(m_fd);
}

std::int64_t DiskFile::read(std::uint64_t at, char* to, std::size_t count) const
{
    std::size_t filled = 0;
    while (filled < count) {
        const ssize_t got = ::pread(m_fd, to + filled, count - filled, static_cast<off_t>(at + filled));
        if (got < 0 && errno != EINTR)
            return -1;
        if (got == 0)
            break; // shortened meanwhile
        filled += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    return static_cast<std::int64_t>(filled);
}

} // namespace bolster
