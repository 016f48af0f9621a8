#include "FileTalk.h"

#include "FileFormats.h"
#include "RecentFiles.h"
#include "Translated.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace bolster {

FileTalk::FileTalk(DesignSession& session, QWidget* window)
    : m_session(session)
    , m_window(window)
{}

QString FileTalk::startFolder() const
{
    return usualFolder(m_session.path());
}

void FileTalk::askForImport(const QString& kind, const QString& title, const QString& filter, const Answer& chosen)
{
    const QString key = QStringLiteral("import-folder/") + kind;
    const QString last = QSettings().value(key).toString();
    askForFile(m_window, title, QFileInfo(last).isDir() ? last : usualFolder(m_session.besideFile()), filter,
               [key, chosen](const QString& path) {
                   QSettings().setValue(key, QFileInfo(path).absolutePath());
                   chosen(path);
               });
}

/// The title without the ending of its file.
QString FileTalk::designName() const
{
    QString name = m_session.title();
    for (const QString& known : endingsOf(FileUse::Design))
        if (name.endsWith(u'.' + known))
            name.chop(known.size() + 1);
    return name;
}

/// Where something else than a project goes: where the last one of this design went.
QString FileTalk::exportFolder() const
{
    return m_exported.of == m_session.path() && QFileInfo(m_exported.folder).isDir() ? m_exported.folder
                                                                                     : startFolder();
}

/// The title as a file in the usual folder.
QString FileTalk::proposed(const QString& ending, const QString& addition) const
{
    QString name = designName();
    name.replace(u'/', u'-');
    return QDir(endingsOf(FileUse::Design).contains(ending) ? startFolder() : exportFolder())
        .filePath(name + addition + u'.' + ending);
}

bool FileTalk::isOpenElsewhere(const QString& path) const
{
    return endingsOf(FileUse::Design).contains(QFileInfo(path).suffix()) && QFileInfo::exists(path) &&
           fileKey(path) != fileKey(m_session.path()) && WorkJournal::isWorkedOn(path);
}

/// A file with one of the endings, the first one if none was typed. Never one of the design's files.
void FileTalk::chooseTarget(const QString& title, const QString& proposal, const QString& filter,
                            const QStringList& endings, const Answer& chosen)
{
    askWhereToWrite(m_window, title, proposal, filter, endings, [this, chosen](const QString& path) {
        if (isOpenElsewhere(path)) {
            fail(tr("\"%1\" is not replaced.").arg(QFileInfo(path).fileName()),
                 {QT_TRANSLATE_NOOP("Message", "it is open in another window; choose another name")});
            return;
        }
        if (!m_session.isElementFile(path)) {
            if (!endingsOf(FileUse::Design).contains(QFileInfo(path).suffix()))
                m_exported = {m_session.path(), QFileInfo(path).absolutePath()};
            chosen(path);
            return;
        }
        fail(tr("\"%1\" is not replaced.").arg(QFileInfo(path).fileName()),
             {QT_TRANSLATE_NOOP("Message", "it is a file that this design refers to; choose another name")});
    });
}

QMessageBox* FileTalk::newBox(QMessageBox::Icon icon, const QString& text, QMessageBox::StandardButtons buttons)
{
    return new QMessageBox(icon, tr("Bolster"), text, buttons, m_window);
}

void FileTalk::fail(const QString& title, const Message& why)
{
    tell(m_window, QMessageBox::Warning, title, translated(why))->setObjectName(QString::fromStdString(why.key));
}

/// Who cancels it stops what it is about.
QPointer<QProgressDialog> FileTalk::showProgress(const QString& text, std::stop_source stop)
{
    QPointer<QProgressDialog> dialog = openProgress(m_window, text).dialog;
    connect(dialog, &QProgressDialog::canceled, this, [dialog, stop]() mutable {
        stop.request_stop();
        closeProgress(dialog);
    });
    return dialog;
}

/// Until the design is there, whoever opens it.
QPointer<QProgressDialog> FileTalk::showReading(const QString& text, const std::stop_source& stop)
{
    closeProgress(m_reading);
    m_reading = showProgress(text, stop);
    connect(&m_session, &DesignSession::opened, m_reading,
            [reading = m_reading.data()] { closeProgress(reading); });
    return m_reading;
}

void FileTalk::remember(const QString& path)
{
    recentFiles::add(path);
    rememberFolder(path);
}

QString FileTalk::readingText(const QString& path)
{
    return tr("Reading %1 \u2026").arg(QFileInfo(path).fileName());
}

} // namespace bolster
