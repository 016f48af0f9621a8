#include "WholeFile.h"

#include "DiskFile.h"

#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

// QSaveFile would do most of this, but it ignores the result of fsync, does not sync the folder (so a power cut
// may bring the old file back after "saved" was shown), and tells a full disk from a read-only folder only in the
// words of the operating system.

namespace bolster {
namespace {

class Descriptor {
public:
    Descriptor(const QString& path, int flags, mode_t mode = 0)
        : m_fd(::open(QFile::encodeName(path).constData(), flags | O_CLOEXEC, mode))
    {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool valid() const { return m_fd >= 0; }
    int get() const { return m_fd; }
    bool close() { return m_fd < 0 || ::close(std::exchange(m_fd, -1)) == 0; }

private:
    int m_fd;
};

Message writeProblem(const QString& path, int error)
{
    const std::string name = path.toStdString();
    const std::string folder = QFileInfo(path).absolutePath().toStdString();
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: the disk is full; make room or choose "
                                             "another folder"),
                {name}};
    case EROFS:
    case EACCES:
    case EPERM:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: you are not allowed to write into \"%2\"; "
                                             "choose another folder"),
                {name, folder}};
    case ENOENT:
    case ENOTDIR:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: there is no folder \"%2\""),
                {name, folder}};
    case EISDIR:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is a folder"), {name}};
    case EINVAL:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is not an ordinary file"), {name}};
    default:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written (%2)"), {name, std::strerror(error)}};
    }
}

/// 0 or an error number, as all helpers below.
int writeAll(int fd, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (written < 0 && errno != EINTR)
            return errno;
        if (written > 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int writeSynced(const QString& temporary, std::string_view bytes, std::optional<mode_t> permissions)
{
    Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (!file.valid())
        return errno;
    if (permissions && ::fchmod(file.get(), *permissions) != 0)
        return errno;
    if (const int error = writeAll(file.get(), bytes))
        return error;
    if (::fsync(file.get()) != 0 || !file.close())
        return errno;
    return 0;
}

int syncFolder(const QString& folder)
{
    const Descriptor descriptor(folder, O_RDONLY | O_DIRECTORY);
    // A folder without read permission and file systems that cannot sync folders: nothing more can be done.
    if (!descriptor.valid() || ::fsync(descriptor.get()) == 0 || errno == EINVAL || errno == ENOTSUP)
        return 0;
    return errno;
}

/// Removes the temporary file if it fails, or if it could not be written (`error`).
int renameSynced(const QString& temporary, const QString& target, int error)
{
    const QByteArray temporaryName = QFile::encodeName(temporary);
    if (!error && std::rename(temporaryName.constData(), QFile::encodeName(target).constData()) != 0)
        error = errno;
    if (error) {
        ::unlink(temporaryName.constData());
        return error;
    }
    return syncFolder(QFileInfo(target).absolutePath());
}

int replaceRegular(const QString& target, std::string_view bytes, std::optional<mode_t> permissions)
{
    const QString temporary = temporaryFileFor(target);
    return renameSynced(temporary, target, writeSynced(temporary, bytes, permissions));
}

int syncWritten(const QString& path, std::optional<mode_t> permissions)
{
    Descriptor file(path, O_RDWR);
    if (!file.valid() || (permissions && ::fchmod(file.get(), *permissions) != 0) || ::fsync(file.get()) != 0 ||
        !file.close())
        return errno;
    return 0;
}

QString resolved(const QString& path)
{
    const QFileInfo info(path);
    return info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
}

/// Why a file that is there must not be replaced.
Message protection(const QString& path, const QString& target, const struct stat& present)
{
    if (S_ISDIR(present.st_mode))
        return writeProblem(path, EISDIR);
    if (S_ISREG(present.st_mode) && ::access(QFile::encodeName(target).constData(), W_OK) != 0)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is write-protected"),
                {path.toStdString()}};
    return {};
}

} // namespace

WholeFile readWholeFile(const QString& path, std::int64_t largest)
{
    WholeFile result;
    const auto file = DiskFile::open(path, largest, result.problem);
    if (!file)
        return result;
    try {
        result.bytes.resize(static_cast<std::size_t>(file->size()));
    } catch (const std::bad_alloc&) {
        return {{}, readProblem(path, ENOMEM)};
    }
    const std::int64_t got = file->read(0, result.bytes.data(), result.bytes.size());
    if (got < 0)
        return {{}, readProblem(path, errno)};
    result.bytes.resize(static_cast<std::size_t>(got));
    return result;
}

Message replaceWholeFile(const QString& path, std::string_view bytes)
{
    const QString target = resolved(path);
    struct stat present = {};
    if (::stat(QFile::encodeName(target).constData(), &present) != 0) {
        const int error = replaceRegular(target, bytes, std::nullopt);
        return error ? writeProblem(path, error) : Message{};
    }
    if (Message problem = protection(path, target, present); !problem.empty())
        return problem;

    int error = 0;
    if (S_ISREG(present.st_mode)) {
        error = replaceRegular(target, bytes, present.st_mode & 0777);
    } else {
        Descriptor device(target, O_WRONLY);
        error = device.valid() ? writeAll(device.get(), bytes) : errno;
    }
    return error ? writeProblem(path, error) : Message{};
}

QString temporaryFileFor(const QString& path)
{
    return QFileInfo(resolved(path)).absolutePath() + "/.bolster-" + QUuid::createUuid().toString(QUuid::Id128);
}

Message moveIntoPlace(const QString& temporary, const QString& path)
{
    const QString target = resolved(path);
    struct stat present = {};
    std::optional<mode_t> permissions;
    if (::stat(QFile::encodeName(target).constData(), &present) == 0) {
        Message problem = protection(path, target, present);
        if (problem.empty() && !S_ISREG(present.st_mode))
            problem = writeProblem(path, EINVAL);
        if (!problem.empty()) {
            QFile::remove(temporary);
            return problem;
        }
        permissions = present.st_mode & 0777;
    }
    const int error = renameSynced(temporary, target, syncWritten(temporary, permissions));
    return error ? writeProblem(path, error) : Message{};
}

} // namespace bolster
