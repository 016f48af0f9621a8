// Takes pictures of the real window for the documents.
#pragma once

#include "MainWindow.h"

#include <QDir>
#include <QElapsedTimer>

#include <functional>

namespace bolster {

/// False when it took too long.
template <class Condition>
bool waitFor(Condition condition, int mostMs)
{
    QElapsedTimer time;
    time.start();
    while (!condition() && time.elapsed() < mostMs)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    return condition();
}

class Photographer {
public:
    /// Files are called "GROUP-name.png".
    Photographer(MainWindow& window, const QDir& folder, const QString& group)
        : m_window(window)
        , m_folder(folder)
        , m_group(group)
    {}

    /// Of the window when its cover has come to rest, with what lies over it.
    void take(const QString& name);
    /// Of this part of the screen, as it is.
    void take(const QString& name, const QRect& place);

    bool good() const { return m_good; }

private:
    MainWindow& m_window;
    QDir m_folder;
    QString m_group;
    bool m_good = true;
};

/// The program of one that plays a path: with the settings of a newcomer in English, in the light theme. `words`
/// are what it takes: "FOLDER". Returns the exit code.
int photograph(int argc, char* argv[], const char* words, const std::function<int(const QStringList&)>& play);

} // namespace bolster
