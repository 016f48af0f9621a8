// What opening, saving, importing and exporting ask and say in the same way: boxes, progress, proposed names.
#pragma once

#include "Ask.h"
#include "DesignSession.h"

#include <QMessageBox>
#include <QPointer>
#include <QProgressDialog>

#include <stop_token>

namespace bolster {

class FileTalk : public QObject {
    Q_OBJECT

public:
    FileTalk(DesignSession& session, QWidget* window);

    QWidget* window() const { return m_window; }
    QMessageBox* newBox(QMessageBox::Icon icon, const QString& text, QMessageBox::StandardButtons buttons);
    void fail(const QString& title, const Message& why);
    void say(const QString& what) { emit done(what); }

    /// Who cancels it stops what it is about.
    QPointer<QProgressDialog> showProgress(const QString& text, std::stop_source stop);
    /// Until the design is there, whoever opens it.
    QPointer<QProgressDialog> showReading(const QString& text, const std::stop_source& stop);
    bool reading() const { return m_reading; }
    static QString readingText(const QString& path);

    /// The title without the ending of its file.
    QString designName() const;
    /// The folder of files that are read.
    QString startFolder() const;
    /// Asks for a file to bring in, where the last one of its kind was.
    void askForImport(const QString& kind, const QString& title, const QString& filter, const Answer& chosen);
    /// The title as a file in the usual folder.
    QString proposed(const QString& ending, const QString& addition = {}) const;
    /// A file with one of the endings, the first one if none was typed. Never one of the design's files.
    void chooseTarget(const QString& title, const QString& proposal, const QString& filter,
                      const QStringList& endings, const Answer& chosen);
    /// Among the recent files.
    void remember(const QString& path);

signals:
    /// Something has happened that is worth a line in the status bar.
    void done(const QString& what);

private:
    QString exportFolder() const;
    /// A project or design that another window works on.
    bool isOpenElsewhere(const QString& path) const;

    struct Exported {
        QString of; ///< the design's file
        QString folder;
    };

    DesignSession& m_session;
    QWidget* m_window;
    QPointer<QProgressDialog> m_reading; ///< of the design that is being opened
    Exported m_exported;                 ///< the last time
};

} // namespace bolster
