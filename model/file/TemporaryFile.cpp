#include "TemporaryFile.h"

#include "DiskFile.h"
#include "PosixFile.h"
#include "Unfinished.h"
#include "WholeFile.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSysInfo>
#include <QUuid>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <optional>
#include <sys/file.h>

namespace bolster {
namespace {

constexpr std::uint64_t bytesAtOnce = 1 << 20;
constexpr int triesAtMost = 10;
constexpr const char* besideIt = "-journal"; // SQLite does not always remove its own

/// With this the names of this machine's temporary files begin: only for them the locks mean anything.
QString ownPrefix()
{
    const QByteArray machine = QSysInfo::machineUniqueId() + QSysInfo::machineHostName().toUtf8();
    const QByteArray hash = QCryptographicHash::hash(machine, QCryptographicHash::Blake2b_256).toHex();
    return QStringLiteral(".bolster-%1-").arg(QString::fromLatin1(hash.first(8)));
}

/// Whether the lock could be had, or the file system has none.
enum class Lock { Ours, Taken, Unknown };

Lock lockNow(const Descriptor& file)
{
    if (::flock(file.get(), LOCK_EX | LOCK_NB) == 0)
        return Lock::Ours;
    return errno == EWOULDBLOCK ? Lock::Taken : Lock::Unknown;
}

bool hasName(const Descriptor& file)
{
    const auto info = statusOf(file);
    return info && info->st_nlink > 0;
}

Message alreadyThere(const QString& path)
{
    return {QT_TRANSLATE_NOOP("Message", "\"%1\" is there already; choose another name"), {path.toStdString()}};
}

/// Returns an error number, or 0. Where file systems cannot see to it that nothing is replaced, who called has.
int renamed(const QString& from, const QString& to, bool mustBeFree)
{
    const QByteArray source = QFile::encodeName(from), target = QFile::encodeName(to);
#ifdef RENAME_NOREPLACE
    if (mustBeFree) {
        if (::renameat2(AT_FDCWD, source.constData(), AT_FDCWD, target.constData(), RENAME_NOREPLACE) == 0)
            return 0;
        if (errno != EINVAL && errno != ENOSYS)
            return errno;
    }
#endif
    return std::rename(source.constData(), target.constData()) == 0 ? 0 : errno;
}

void removeIfLeft(const QFileInfo& info, const QString& own)
{
    const Descriptor file(info.absoluteFilePath(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    if (!file.valid())
        return;
    const Lock lock = lockNow(file);
    const bool old = info.lastModified() < QDateTime::currentDateTime().addDays(-1);
    const bool left = lock == Lock::Ours && info.fileName().startsWith(own) ? true : lock != Lock::Taken && old;
    if (!left || !hasName(file))
        return;
    QFile::remove(info.absoluteFilePath());
    QFile::remove(info.absoluteFilePath() + besideIt);
}

} // namespace

struct TemporaryFile::File {
    Descriptor descriptor;
    std::optional<Unfinished> unfinished, beside;
};

TemporaryFile::TemporaryFile(const QString& target)
    : m_target(resolved(target))
    , m_file(std::make_unique<File>())
{
    const QString folder = QFileInfo(m_target).absolutePath();
    for (int tries = 0; tries < triesAtMost; ++tries) {
        m_path = folder + '/' + ownPrefix() + QUuid::createUuid().toString(QUuid::Id128);
        m_file->descriptor = Descriptor(m_path, O_RDWR | O_CREAT | O_EXCL, 0666);
        if (!m_file->descriptor.valid()) {
            m_problem = writeProblem(m_target, errno);
            return;
        }
        // Whoever removes what is left may have been faster.
        if (lockNow(m_file->descriptor) != Lock::Taken && hasName(m_file->descriptor)) {
            m_file->unfinished.emplace(m_path);
            m_file->beside.emplace(m_path + besideIt);
            return;
        }
    }
    m_file->descriptor.close();
    m_problem = writeProblem(m_target, EBUSY);
}

TemporaryFile::~TemporaryFile()
{
    if (m_file->descriptor.valid())
        QFile::remove(m_path);
    QFile::remove(m_path + besideIt);
}

Message TemporaryFile::failed(int error)
{
    return writeProblem(m_target, error);
}

Message TemporaryFile::write(std::string_view bytes)
{
    if (!m_problem.empty())
        return m_problem;
    const int error = writeAll(m_file->descriptor, bytes);
    return error ? failed(error) : Message{};
}

Message TemporaryFile::copyFrom(const QString& path)
{
    Message unreadable;
    const auto file = DiskFile::open(path, std::numeric_limits<std::int64_t>::max(), unreadable);
    if (!file)
        return unreadable;
    std::string bytes;
    for (std::uint64_t at = 0; at < file->size(); at += bytes.size()) {
        bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(bytesAtOnce, file->size() - at)));
        const std::int64_t got = file->read(at, bytes.data(), bytes.size());
        if (got < static_cast<std::int64_t>(bytes.size()))
            return readProblem(path, got < 0 ? errno : EIO);
        if (Message problem = write(bytes); !problem.empty())
            return problem;
    }
    return m_problem;
}

Message TemporaryFile::moveIntoPlace(Place place)
{
    if (!m_problem.empty())
        return m_problem;
    const Descriptor& file = m_file->descriptor;
    const auto present = statusOf(m_target);
    if (present && place == Place::MustBeFree)
        return alreadyThere(m_target);
    if (present) {
        if (Message problem = protection(m_target, *present); !problem.empty())
            return problem;
        if (!S_ISREG(present->st_mode))
            return failed(EINVAL);
        if (::fchmod(file.get(), present->st_mode & 0777) != 0)
            return failed(errno);
    }
    if (::fsync(file.get()) != 0)
        return failed(errno);
    if (const int error = renamed(m_path, m_target, place == Place::MustBeFree))
        return error == EEXIST ? alreadyThere(m_target) : failed(error);
    const bool closed = m_file->descriptor.close();
    const int error = syncFolder(QFileInfo(m_target).absolutePath());
    return error || !closed ? failed(error ? error : EIO) : Message{};
}

void removeLeftTemporaryFiles(const QString& folder)
{
    static const QRegularExpression name("^\\.bolster-([0-9a-f]{8}-)?[0-9a-f]{32}$");
    const QString own = ownPrefix();
    for (const QFileInfo& info : QDir(folder).entryInfoList({".bolster-*"}, QDir::Files | QDir::Hidden))
        if (name.match(info.fileName()).hasMatch())
            removeIfLeft(info, own);
}

} // namespace bolster
