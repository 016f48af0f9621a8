#include "PosixFile.h"

#include <QFileInfo>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace bolster {

std::optional<struct stat> statusOf(const QString& path)
{
    struct stat result = {};
    return ::stat(QFile::encodeName(path).constData(), &result) == 0 ? std::optional(result) : std::nullopt;
}

std::optional<struct stat> statusOf(const Descriptor& file)
{
    struct stat result = {};
    return ::fstat(file.get(), &result) == 0 ? std::optional(result) : std::nullopt;
}

int writeAll(const Descriptor& file, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (written < 0 && errno != EINTR)
            return errno;
        if (written > 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
    }
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
        if (QFileInfo(QString::fromStdString(folder)).isDir()) // one of the system's, as /proc
            return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: no file can be made in \"%2\"; choose "
                                                 "another folder"),
                    {name, folder}};
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: there is no folder \"%2\""),
                {name, folder}};
    case EISDIR:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is a folder"), {name}};
    case EINVAL:
    case ENXIO: // a pipe that nobody reads
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is not an ordinary file"), {name}};
    default:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written (%2)"), {name, std::strerror(error)}};
    }
}

Message protection(const QString& path, const struct stat& present)
{
    if (S_ISDIR(present.st_mode))
        return writeProblem(path, EISDIR);
    if (S_ISREG(present.st_mode) && ::access(QFile::encodeName(path).constData(), W_OK) != 0)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is write-protected"),
                {path.toStdString()}};
    return {};
}

} // namespace bolster
