#include "Jobs.h"

#include <algorithm>

namespace bolster {

Jobs& Jobs::all()
{
    static Jobs jobs;
    return jobs;
}

int Jobs::begin(const QString& name, std::function<void()> cancel)
{
    m_running.append({++m_last, name, -1, std::move(cancel)});
    emit changed();
    return m_last;
}

void Jobs::report(int number, double share)
{
    const auto job = std::ranges::find(m_running, number, &Job::number);
    if (job == m_running.end())
        return;
    job->share = share;
    emit progressed(number, share);
}

void Jobs::end(int number)
{
    if (m_running.removeIf([number](const Job& job) { return job.number == number; }) > 0)
        emit changed();
}

void Jobs::cancel(int number)
{
    const auto job = std::ranges::find(m_running, number, &Job::number);
    if (job == m_running.end())
        return;
    const std::function<void()> stop = job->cancel; // the job may end by it
    if (stop)
        stop();
}

void Jobs::cancelAll()
{
    const QList<Job> running = m_running;
    for (const Job& job : running)
        cancel(job.number);
}

} // namespace bolster
