#include "RecentFiles.h"

#include <QDir>
#include <QFileInfo>
#include <QFontMetrics>
#include <QSettings>

#include <algorithm>

namespace bolster::recentFiles {

namespace {

const QString recentFilesKey = QStringLiteral("recent");
constexpr qsizetype mostRecentFiles = 10;

} // namespace

QStringList remembered()
{
    return QSettings().value(recentFilesKey).toStringList();
}

QStringList all()
{
    QStringList files = remembered();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

void add(const QString& path)
{
    QSettings settings;
    QStringList files = settings.value(recentFilesKey).toStringList();
    const QString file = QFileInfo(path).absoluteFilePath();
    files.removeAll(file);
    files.prepend(file);
    settings.setValue(recentFilesKey, QStringList(files.mid(0, mostRecentFiles)));
}

void remove(const QString& path)
{
    QStringList files = remembered();
    files.removeAll(path);
    QSettings().setValue(recentFilesKey, files);
}

void clear()
{
    QSettings().remove(recentFilesKey);
}

QString folderText(const QString& path, const QFontMetrics& metrics, int width)
{
    QString folder = QFileInfo(path).absolutePath();
    const QString home = QDir::homePath();
    if (folder == home || folder.startsWith(home + u'/'))
        folder.replace(0, home.size(), QStringLiteral("~"));
    return metrics.elidedText(QDir::toNativeSeparators(folder), Qt::ElideMiddle, width);
}

} // namespace bolster::recentFiles
