// Beginning anew and opening designs.
#pragma once

#include "FileTalk.h"

#include <functional>

class QMenu;

namespace bolster {

class Banner;
class LeftWork;
class Rescue;
class SaveFlow;

class OpenFlow : public QObject {
    Q_OBJECT

public:
    using Then = std::function<void()>;
    struct Parts {
        FileTalk& talk;
        SaveFlow& saving;
        LeftWork& left;
        Rescue& rescue;
        Banner& banner;
    };

    OpenFlow(DesignSession& session, const Parts& parts);

    void startNew(const Then& begun = {});
    /// Asks for a file when `path` is empty. `opened` is called when it is there.
    void open(const QString& path = {}, const Then& opened = {});
    /// As a new design without a name.
    void openTemplate(const QString& path);
    void fillRecent(QMenu& menu);
    void fillSamples(QMenu& menu);

signals:
    /// The user wants to see what is wrong.
    void problemsWanted();

private:
    void openNow(const QString& path, const Then& opened = {});
    void openAs(const QString& path, DesignSession::Opening opening, const Then& opened);
    void announceProblems();

    DesignSession& m_session;
    FileTalk& m_talk;
    SaveFlow& m_saving;
    LeftWork& m_left;
    Rescue& m_rescue;
    Banner& m_banner;
};

} // namespace bolster
