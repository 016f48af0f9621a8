#include "DesignFolder.h"

#include "ElementEdits.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace bolster {

namespace {

QString ownRoot()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/untitled");
}

/// Beside the folder. Only that of a program that has ended can be had: no age makes it invalid.
std::unique_ptr<QLockFile> lockOfOwn(const QString& folder)
{
    auto lock = std::make_unique<QLockFile>(folder + QStringLiteral(".lock"));
    lock->setStaleLockTime(0);
    return lock->tryLock(0) ? std::move(lock) : nullptr;
}

bool sameContent(const QString& a, const QString& b)
{
    if (QFileInfo(a).canonicalFilePath() == QFileInfo(b).canonicalFilePath())
        return true;
    QFile first(a);
    QFile second(b);
    if (!first.open(QIODevice::ReadOnly) || !second.open(QIODevice::ReadOnly) || first.size() != second.size())
        return false;
    constexpr qint64 block = 1 << 20;
    while (!first.atEnd())
        if (first.read(block) != second.read(block))
            return false;
    return true;
}

/// `name`, or with a number behind it, such that the folder has no other file of that name.
QString freeName(const QDir& folder, const QString& name, const QString& source,
                 const std::function<bool(const QString&)>& taken = {})
{
    const auto isTaken = [&](const QString& candidate) {
        const QString path = folder.filePath(candidate);
        return QFileInfo::exists(path) ? !sameContent(path, source) : taken && taken(candidate);
    };
    const QFileInfo info(name);
    QString candidate = name;
    for (int i = 2; isTaken(candidate); ++i)
        candidate = QStringLiteral("%1-%2.%3").arg(info.completeBaseName()).arg(i).arg(info.suffix());
    return candidate;
}

Message copyInto(const QDir& folder, const QString& name, const QString& source)
{
    const QString target = folder.filePath(name);
    if (QFileInfo::exists(target))
        return {}; // freeName has seen that it is the same
    folder.mkpath(QFileInfo(target).path());
    QFile file(source);
    if (file.copy(target))
        return {};
    return {QT_TRANSLATE_NOOP("Message", "\"%1\" could not be copied to \"%2\": %3"),
            {source.toStdString(), target.toStdString(), file.errorString().toStdString()}};
}

} // namespace

OwnFolder::OwnFolder(const QString& path, std::unique_ptr<QLockFile> lock)
    : m_path(path)
    , m_lock(std::move(lock))
{}

OwnFolder::~OwnFolder()
{
    if (!m_kept)
        QDir(m_path).removeRecursively();
}

std::shared_ptr<OwnFolder> OwnFolder::make()
{
    return takeOver(ownRoot() + u'/' + QUuid::createUuid().toString(QUuid::WithoutBraces));
}

std::shared_ptr<OwnFolder> OwnFolder::takeOver(const QString& path)
{
    if (path.isEmpty() || QFileInfo(path).absolutePath() != QFileInfo(ownRoot()).absoluteFilePath() ||
        !QDir().mkpath(ownRoot()))
        return nullptr;
    auto lock = lockOfOwn(path); // before there is a folder that somebody might find forgotten
    if (!lock || !QDir().mkpath(path))
        return nullptr;
    return std::shared_ptr<OwnFolder>(new OwnFolder(path, std::move(lock)));
}

void OwnFolder::removeForgotten(const QStringList& wanted)
{
    for (const QFileInfo& folder : QDir(ownRoot()).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot))
        if (const QString path = folder.absoluteFilePath(); !wanted.contains(path))
            if (const auto lock = lockOfOwn(path))
                QDir(path).removeRecursively();
}

QString DesignFolder::find(const QString& name) const
{
    const QString clean = QDir::cleanPath(name);
    if (clean.isEmpty() || clean == QLatin1String(".") || QDir::isAbsolutePath(clean) ||
        clean.startsWith(QLatin1String("..")))
        return {};
    for (const QString& folder : QStringList(m_folder) + m_earlier)
        if (const QString file = QDir(folder).filePath(clean); !folder.isEmpty() && QFileInfo(file).isFile())
            return file;
    return {};
}

void DesignFolder::start(const QString& folder, const std::shared_ptr<OwnFolder>& own)
{
    m_earlier.clear();
    m_own.clear();
    m_folder = own ? own->path() : folder;
    if (own) {
        own->keep(false);
        m_own.push_back(own);
    }
}

void DesignFolder::leave()
{
    for (const std::shared_ptr<OwnFolder>& own : m_own)
        own->keep();
    m_own.clear();
    m_earlier.clear();
    m_folder.clear();
}

bool DesignFolder::ownFolder() const
{
    return std::ranges::any_of(m_own, [&](const auto& own) { return own->path() == m_folder; });
}

void DesignFolder::moved(const QString& folder)
{
    if (folder == m_folder)
        return;
    if (!m_folder.isEmpty())
        m_earlier.prepend(m_folder);
    m_folder = folder;
}

Message DesignFolder::makeOwnFolder(const Design& design)
{
    const auto own = OwnFolder::make();
    if (!own)
        return {QT_TRANSLATE_NOOP("Message", "the folder \"%1\" could not be made"), {ownRoot().toStdString()}};
    m_own.push_back(own);
    Design copied;
    Message problem = copyTo(own->path(), design, &copied);
    moved(own->path());
    return problem;
}

Message DesignFolder::add(const QString& source, QString* name,
                          const std::function<bool(const QString& name)>& taken) const
{
    const QDir folder(m_folder);
    const QString inside = folder.relativeFilePath(QFileInfo(source).absoluteFilePath());
    if (!QDir::isAbsolutePath(inside) && !inside.startsWith(QLatin1String(".."))) {
        *name = inside;
        return {};
    }
    *name = freeName(folder, QFileInfo(source).fileName(), source, taken);
    return copyInto(folder, *name, source);
}

Message DesignFolder::copyTo(const QString& target, const Design& design, Design* moved) const
{
    *moved = design;
    const QDir to(target);
    Message problem;
    for (const auto& [id, element] : design.elements()) {
        const std::string* file = elementFile(*element);
        const QString name = file ? QString::fromStdString(*file) : QString();
        const QString source = find(name);
        if (!problem.empty() || source.isEmpty())
            continue;
        const QString free = freeName(to, name, source);
        problem = copyInto(to, free, source);
        if (free != name)
            *moved = moved->with(edits::replaceElement(*moved, id, withFile(*element, free.toStdString()), {}));
    }
    return problem;
}

} // namespace bolster
