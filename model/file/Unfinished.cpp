#include "Unfinished.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <mutex>
#include <set>
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

void removeUnfinished()
{
    const std::scoped_lock lock(unfinished().mutex);
    for (const QString& path : unfinished().paths) {
        if (path.isEmpty())
            continue;
        if (QFileInfo(path).isDir())
            QDir(path).removeRecursively();
        else
            QFile::remove(path);
    }
}

} // namespace bolster
