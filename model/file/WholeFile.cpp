#include "WholeFile.h"

#include "DirectWrite.h"
#include "DiskFile.h"
#include "PosixFile.h"
#include "TemporaryFile.h"

#include <QFileInfo>

#include <algorithm>
#include <cerrno>
#include <new>

// QSaveFile would do most of this, but it ignores the result of fsync, does not sync the folder (so a power cut
// may bring the old file back after "saved" was shown), and tells a full disk from a read-only folder only in the
// words of the operating system.

namespace bolster {

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

Message copyWholeFile(const QString& from, const QString& to, std::int64_t largest)
{
    constexpr std::size_t copiedAtOnce = 1 << 20;
    Message problem;
    const auto file = DiskFile::open(from, largest, problem);
    if (!file)
        return problem;
    Descriptor copy(to, O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (!copy.valid())
        return writeProblem(to, errno);
    std::string bytes;
    for (std::uint64_t at = 0; at < file->size(); at += bytes.size()) {
        bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(copiedAtOnce, file->size() - at)));
        const std::int64_t got = file->read(at, bytes.data(), bytes.size());
        if (got < static_cast<std::int64_t>(bytes.size()))
            return readProblem(from, got < 0 ? errno : EIO);
        if (const int error = writeAll(copy, bytes))
            return writeProblem(to, error);
    }
    return copy.close() ? Message{} : writeProblem(to, errno);
}

Message replaceWholeFile(const QString& path, std::string_view bytes)
{
    const auto there = statusOf(path);
    // The links to open pipes ("/dev/stdout") lead to names that are no files.
    const bool isDirect = there && !S_ISREG(there->st_mode) && !S_ISDIR(there->st_mode);
    const QString target = isDirect ? path : resolved(path);
    const auto present = statusOf(target);
    if (!present && QFileInfo(target).isSymLink())
        return writeProblem(path, ELOOP);
    if (present)
        if (Message problem = protection(target, *present); !problem.empty())
            return problem;
    if (!present || S_ISREG(present->st_mode)) {
        TemporaryFile file(target);
        Message problem = file.write(bytes);
        return problem.empty() ? file.moveIntoPlace() : problem;
    }
    const Descriptor device(target, O_WRONLY | O_NONBLOCK); // nobody is waited for who might read
    if (!device.valid() || ::fcntl(device.get(), F_SETFL, 0) != 0)
        return writeProblem(path, errno);
    const DirectWrite direct;
    const int error = writeAll(device, bytes);
    return error ? writeProblem(path, error) : Message{};
}

Message createWholeFile(const QString& path, std::string_view bytes)
{
    const auto there = statusOf(path);
    if (there && !S_ISREG(there->st_mode))
        return replaceWholeFile(path, bytes); // "/dev/stdout", or a folder
    TemporaryFile file(path);
    Message problem = file.write(bytes);
    return problem.empty() ? file.moveIntoPlace(TemporaryFile::Place::MustBeFree) : problem;
}

QString resolved(const QString& path)
{
    constexpr int mostLinks = 40;
    QFileInfo info(path);
    for (int k = 0; k < mostLinks && !info.exists() && info.isSymLink(); ++k)
        info.setFile(info.symLinkTarget()); // to a file that is not there yet
    return info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
}

QString fileKey(const QString& path)
{
    if (const auto there = statusOf(path))
        return QStringLiteral("%1 %2").arg(there->st_dev).arg(there->st_ino);
    const QFileInfo file(resolved(path));
    const QString folder = QFileInfo(file.absolutePath()).canonicalFilePath();
    return folder.isEmpty() ? file.absoluteFilePath() : folder + u'/' + file.fileName();
}

} // namespace bolster
