// What the program works at beside its windows, and could be stopped.
#pragma once

#include <QList>
#include <QObject>
#include <QString>

#include <functional>

namespace bolster {

/// Of the GUI thread. Whoever works registers with a RunningJob.
class Jobs : public QObject {
    Q_OBJECT

public:
    struct Job {
        int number;
        QString name;      ///< "Writing seat.dxf …"
        double share = -1; ///< 0 to 1; less than 0: nobody knows
        std::function<void()> cancel;
    };

    /// One for the program: it has one window, and its dialogs work too.
    static Jobs& all();

    const QList<Job>& running() const { return m_running; }
    /// Asks it to stop; it ends when it does.
    void cancel(int number);
    void cancelAll();

signals:
    /// One more, or one fewer.
    void changed();
    void progressed(int number, double share);

private:
    friend class RunningJob;
    int begin(const QString& name, std::function<void()> cancel);
    void report(int number, double share);
    void end(int number);

    QList<Job> m_running;
    int m_last = 0;
};

/// In the list of jobs as long as it lives.
class RunningJob {
public:
    RunningJob(const QString& name, std::function<void()> cancel)
        : m_number(Jobs::all().begin(name, std::move(cancel)))
    {}
    ~RunningJob() { Jobs::all().end(m_number); }
    RunningJob(const RunningJob&) = delete;
    RunningJob& operator=(const RunningJob&) = delete;

    void report(double share) { Jobs::all().report(m_number, share); }

private:
    int m_number;
};

} // namespace bolster
