// Takes pictures of the real window for the documents.
#pragma once

#include "MainWindow.h"

#include <QDir>
#include <QElapsedTimer>

namespace bolster {

template <class Condition>
void waitFor(Condition condition, int mostMs)
{
    QElapsedTimer time;
    time.start();
    while (!condition() && time.elapsed() < mostMs)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
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

} // namespace bolster
