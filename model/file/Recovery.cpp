#include "Recovery.h"

#include "DesignJson.h"
#include "WholeFile.h"

#include <QDir>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace bolster {
namespace {

constexpr int delayMs = 1000; // from the first change that the copy lacks
constexpr std::int64_t longestPath = 100'000;

QString recoveryFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery";
}

/// Only the lock of a program that has ended can be had: no age makes a lock invalid.
std::unique_ptr<QLockFile> lockOf(const QString& base)
{
    auto lock = std::make_unique<QLockFile>(base + ".lock");
    lock->setStaleLockTime(0);
    return lock->tryLock(0) ? std::move(lock) : nullptr;
}

QString baseOf(const Recovery::Orphan& orphan)
{
    return orphan.file.chopped(5); // ".json"
}

void removeCopy(const QString& base)
{
    QFile::remove(base + ".json"); // first: without it the other means nothing
    QFile::remove(base + ".origin");
}

/// The path first: a copy is never without it.
Message writeCopy(const QString& base, const Design& design, const QString& original)
{
    const std::string origin = original.toStdString();
    if (readWholeFile(base + ".origin", longestPath).bytes != origin)
        if (Message problem = replaceWholeFile(base + ".origin", origin); !problem.empty())
            return problem;
    return replaceWholeFile(base + ".json", writeDesign(design));
}

} // namespace

QString Recovery::Orphan::frameFolder() const
{
    return original.isEmpty() ? QString() : QFileInfo(original).absolutePath();
}

bool Recovery::Orphan::fileIsNewer() const
{
    return !original.isEmpty() && QFileInfo(original).lastModified() > when;
}

QList<Recovery::Orphan> Recovery::orphans()
{
    QList<Orphan> found;
    for (const QFileInfo& copy : QDir(recoveryFolder()).entryInfoList({"*.json"}, QDir::Files, QDir::Time)) {
        Orphan orphan{{}, copy.lastModified(), copy.absoluteFilePath()};
        if (!lockOf(baseOf(orphan)))
            continue;
        orphan.original = QString::fromStdString(readWholeFile(baseOf(orphan) + ".origin", longestPath).bytes);
        found.append(orphan);
    }
    return found;
}

void Recovery::discard(const Orphan& orphan)
{
    if (const auto lock = lockOf(baseOf(orphan)))
        removeCopy(baseOf(orphan));
}

Recovery::Recovery(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_base(recoveryFolder() + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces))
{
    m_jobs.setMaxThreadCount(1);
    m_timer.setSingleShot(true);
    m_timer.setInterval(delayMs);
    connect(&m_timer, &QTimer::timeout, this, &Recovery::write);
    connect(&document, &Document::historyChanged, this, &Recovery::follow);
    connect(&document, &Document::dirtyChanged, this, &Recovery::follow);
}

Recovery::~Recovery()
{
    if (m_timer.isActive())
        write();
    m_jobs.waitForDone();
}

void Recovery::setOriginal(const QString& path)
{
    m_original = path.isEmpty() ? path : QFileInfo(path).absoluteFilePath();
}

bool Recovery::adopt(const Orphan& orphan)
{
    auto taken = lockOf(baseOf(orphan));
    if (!taken || !QFile::exists(orphan.file))
        return false;
    remove();
    m_jobs.waitForDone(); // before our old lock goes
    m_lock = std::move(taken);
    m_base = baseOf(orphan);
    setOriginal(orphan.original);
    follow();
    return true;
}

void Recovery::discard()
{
    m_timer.stop();
    remove();
}

/// The timer is not started again by later changes, so that steady work is copied too.
void Recovery::follow()
{
    if (!m_document.dirty()) {
        discard();
        return;
    }
    m_unsaved = m_document.committed();
    if (!m_timer.isActive())
        m_timer.start();
}

void Recovery::write()
{
    m_timer.stop();
    if (!lock())
        return;
    m_jobs.clear(); // the latest wins
    m_jobs.start([this, base = m_base, design = m_unsaved, original = m_original] {
        const Message problem = writeCopy(base, design, original);
        if (!problem.empty()) // the destructor waits for us, so we are alive
            QMetaObject::invokeMethod(
                this, [this, problem] { emit failed(problem); }, Qt::QueuedConnection);
    });
}

void Recovery::remove()
{
    if (!m_lock)
        return;
    m_jobs.clear();
    m_jobs.start([base = m_base] { removeCopy(base); });
}

bool Recovery::lock()
{
    if (m_lock)
        return true;
    QDir().mkpath(recoveryFolder());
    m_lock = lockOf(m_base);
    if (!m_lock)
        emit failed({QT_TRANSLATE_NOOP("Message", "unsaved work cannot be protected: \"%1\" cannot be written"),
                     {recoveryFolder().toStdString()}});
    return m_lock != nullptr;
}

} // namespace bolster
