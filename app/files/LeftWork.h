// Unsaved work: what a crash has left, and what was kept for later.
#pragma once

#include "FileTalk.h"
#include "WorkJournal.h"

class QMenu;

namespace bolster {

class Banner;
class Rescue;
class SaveFlow;

class LeftWork : public QObject {
    Q_OBJECT

public:
    struct Parts {
        FileTalk& talk;
        SaveFlow& saving;
        Rescue& rescue;
        Banner& banner;
    };

    LeftWork(DesignSession& session, const Parts& parts);

    /// Of unsaved work, as the user knows it.
    static QString nameOf(const WorkJournal::Left& left);
    /// Goes on with unsaved work.
    void openLeft(const WorkJournal::Left& left);
    /// The same when nobody has to be asked any more. `others`: how much more there is.
    void restore(const WorkJournal::Left& left, int others = 0);
    /// Looks for unsaved work in the background: leftFound.
    void findLeft();
    /// Goes on where a crash has ended the last run, if it has.
    void recover();
    void fillUnsaved(QMenu& menu);

signals:
    /// Work that is not in any file, the newest first, that of this window left out.
    void leftFound(const QList<bolster::WorkJournal::Left>& all);
    /// The user wants to see what has been done.
    void historyWanted();
    /// The work on it is damaged: as it was saved it shall be opened.
    void openWanted(const QString& path);

private:
    void setAside(const WorkJournal::Left& left, const Message& problem);
    void goOnWithout(const WorkJournal::Left& damaged, const Message& problem);
    void announceRestored(int others);

    DesignSession& m_session;
    FileTalk& m_talk;
    SaveFlow& m_saving;
    Rescue& m_rescue;
    Banner& m_banner;
    int m_restored = 0; ///< number of what the banner says about it
};

} // namespace bolster
