#include "Unfinished.h"

#include "PosixFile.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cstdio>
#include <mutex>
#include <set>
#include <sys/file.h>
#include <utility>

namespace bolster {
namespace {

struct UnfinishedPaths {
    std::mutex mutex;
    std::multiset<QString> paths;
};

/// Never destroyed: threads may come here while the program ends.
UnfinishedPaths& unfinished()
{
    static auto* const all = new UnfinishedPaths;
    return *all;
}

const QString workFolderName = QStringLiteral("bolster-work-");

std::unique_ptr<Descriptor> lockedFolder(const QString& path)
{
    auto folder = std::make_unique<Descriptor>(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
    return folder->valid() && ::flock(folder->get(), LOCK_EX | LOCK_NB) == 0 ? std::move(folder) : nullptr;
}

/// Those of this user that no program has, a day old: younger ones may just be getting their lock.
void removeLeftWorkFolders()
{
    const QDateTime yesterday = QDateTime::currentDateTime().addDays(-1);
    for (const QFileInfo& folder :
         QDir(QDir::tempPath())
             .entryInfoList({workFolderName + QStringLiteral("??????")}, QDir::Dirs | QDir::NoSymLinks))
        if (folder.ownerId() == ::geteuid() && folder.lastModified() < yesterday)
            if (const auto lock = lockedFolder(folder.absoluteFilePath()))
                QDir(folder.absoluteFilePath()).removeRecursively();
}

/// Another thread may be making files in it at this very moment: where it is moved to, it makes none.
void removeFolder(const QString& path)
{
    const QTemporaryDir aside(QDir::tempPath() + u'/' + workFolderName + QStringLiteral("XXXXXX"));
    if (!aside.isValid() || ::rename(QFile::encodeName(path), QFile::encodeName(aside.path())) != 0)
        QDir(path).removeRecursively();
}

} // namespace

Unfinished::Unfinished(QString path)
    : m_path(std::move(path))
{
    const std::scoped_lock lock(unfinished().mutex);
    unfinished().paths.insert(m_path);
}

Unfinished::~Unfinished()
{
    const std::scoped_lock lock(unfinished().mutex);
    if (const auto found = unfinished().paths.find(m_path); found != unfinished().paths.end())
        unfinished().paths.erase(found);
}

WorkFolder::WorkFolder()
    : m_folder(QDir::tempPath() + u'/' + workFolderName + QStringLiteral("XXXXXX"))
    , m_unfinished(m_folder.path())
    , m_lock(lockedFolder(m_folder.path()))
{
    removeLeftWorkFolders();
}

WorkFolder::~WorkFolder() = default;

void removeUnfinished()
{
    const std::scoped_lock lock(unfinished().mutex);
    for (const QString& path : unfinished().paths) {
        if (path.isEmpty())
            continue;
        if (QFileInfo(path).isDir())
            removeFolder(path);
        else
            QFile::remove(path);
    }
}

} // namespace bolster
