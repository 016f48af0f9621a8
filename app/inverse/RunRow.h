// Starts long work, shows how far it is, here and in the list of jobs, and stops it.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include <functional>
#include <memory>

class QProgressBar;
class QPushButton;

namespace bolster {

class RunningJob;

class RunRow : public QWidget {
    Q_OBJECT

public:
    /// `text` of the button that starts it; `job`: how it is called in the list of jobs.
    RunRow(QString text, QString job, QWidget* parent = nullptr);
    ~RunRow() override;

    bool running() const { return m_running != nullptr; }
    void setRunning(bool running);
    /// 0 to 1.
    void setShare(double share);

    /// The number of a run that begins, or of none: what belongs to runs before counts no longer.
    int newRun() { return ++m_run; }
    bool isNow(int run) const { return run == m_run; }
    /// From the thread of the work: does it here, if that run still counts then.
    void later(int run, std::function<void()> what);
    /// For the work, to say how far it is.
    std::function<void(double)> sharesOf(int run);

signals:
    void started();
    void stopped();

private:
    QString m_text, m_job;
    QProgressBar* m_bar;
    QPushButton* m_button;
    std::unique_ptr<RunningJob> m_running;
    int m_run = 0;
    QElapsedTimer m_ended; ///< since it came to its end: who means to stop it shall not begin again
};

} // namespace bolster
