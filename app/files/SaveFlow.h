// Saving, and what becomes of work that is in no file.
#pragma once

#include "FileTalk.h"
#include "Project.h"

#include <functional>

namespace bolster {

class Banner;

class SaveFlow : public QObject {
    Q_OBJECT

public:
    using Then = std::function<void()>;

    SaveFlow(DesignSession& session, FileTalk& talk, Banner& banner);

    void save();
    void saveAs();
    void saveCopy(const SaveOptions& options);
    /// To the version that was saved last; the way back is in the history.
    void revert();
    /// There is such a version: the design is in a file of the user's.
    bool hasSaved() const;
    /// Goes on when nothing unsaved is lost by it: saved, discarded on purpose, or nothing was unsaved.
    void keepWork(const Then& then);

signals:
    /// The user wants to see what has been done.
    void historyWanted();

private:
    void askAboutWork(const Then& then);
    void keepForLater(const Then& then);
    void saveForGood(bool asProject, const Then& then);
    void chooseSaveTarget(const Answer& chosen);
    void saveTo(const QString& path, const Then& then);
    void saveCopyTo(const QString& path, const SaveOptions& options);
    void saveElsewhere(const Then& then);
    void saveBesideStranger(const QString& path, const Message& stranger, const Then& then);
    void keepAside(const QString& path, const Then& then);
    void saveBesideOthers(const QString& path, const Then& then);
    void takeTheirs(const QString& path, const Then& then);
    void offerAnotherTry(const QString& path, const Message& problem, const Then& again, const Then& elsewhere);
    void askOrSaveElsewhere(QMessageBox* box, const QString& text, const Then& act, const Then& elsewhere);
    void warnOfCrashes(const Message& why);

    DesignSession& m_session;
    FileTalk& m_talk;
    Banner& m_banner;
    QPointer<QMessageBox> m_question; ///< what becomes of unsaved work
    Message m_unprotected;            ///< why what is done is not protected; empty when it is
};

} // namespace bolster
