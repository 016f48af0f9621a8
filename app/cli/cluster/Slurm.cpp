#include "Slurm.h"

#include "WholeFile.h"

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QThread>

namespace bolster::cli {

namespace {

constexpr int mostArrays = 6;
constexpr unsigned long betweenLooks = 1000; // ms

struct Said {
    bool ok = false;
    std::string output, error;
};

Said ask(const QString& program, const QStringList& words)
{
    QProcess process;
    process.start(program, words, QIODevice::ReadOnly);
    if (!process.waitForStarted())
        return {false, {}, program.toStdString() + " cannot be started: is Slurm installed here?"};
    process.waitForFinished(-1);
    return {process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
            process.readAllStandardOutput().trimmed().toStdString(),
            process.readAllStandardError().trimmed().toStdString()};
}

QString quoted(QString word)
{
    return "'" + word.replace("'", "'\\''") + "'";
}

std::string scriptOf(const SlurmOrder& order)
{
    QString line;
    for (const QString& word : order.command)
        line += quoted(word) + " ";
    return "#!/bin/sh\n# Does its share of the work, and of that what is not there yet.\nexec " +
           line.toStdString() + "--part \"$SLURM_ARRAY_TASK_ID/" + std::to_string(order.jobs) + "\"\n";
}

} // namespace

std::string whyNoSlurm()
{
    return QStandardPaths::findExecutable("sbatch").isEmpty() ? "sbatch is not there: is Slurm installed here?"
                                                              : "";
}

SlurmOrder SlurmOrder::from(const Arguments& arguments, const QString& subcommand, const QString& folder)
{
    for (const char* option : {"--jobs", "--sbatch"})
        if (arguments.has(option) && !arguments.has("--slurm"))
            throw UsageError(std::string(option) + " is for jobs of Slurm: give --slurm, too");
    SlurmOrder order;
    order.folder = folder;
    order.name = "bolster-" + subcommand;
    order.jobs = arguments.integer("--jobs", order.jobs, 1, 10'000);
    order.command = {QFile::symLinkTarget("/proc/self/exe"), subcommand};
    order.options = arguments.path("--sbatch").split(' ', Qt::SkipEmptyParts);
    return order;
}

std::string runOnSlurm(const SlurmOrder& order, const std::function<bool()>& isDone,
                       const std::function<void(const std::string&)>& say, const std::stop_token& stop)
{
    const QString script = order.folder + "/job.sh";
    if (const Message problem = replaceWholeFile(script, scriptOf(order)); !problem.empty())
        return problem.english();
    for (int array = 0; array < mostArrays && !isDone(); ++array) {
        const Said submitted =
            ask("sbatch", QStringList{"--parsable", "--array=0-" + QString::number(order.jobs - 1),
                                      "--job-name=" + order.name, "--requeue",
                                      "--output=" + order.folder + "/job-%A-%a.log"} +
                              order.options + QStringList{script});
        if (!submitted.ok)
            return "sbatch: " + submitted.error;
        const QString id = QString::fromStdString(submitted.output).section(';', 0, 0);
        say("job " + id.toStdString());
        for (;;) {
            if (stop.stop_requested()) {
                ask("scancel", {id});
                return "interrupted";
            }
            const Said queue = ask("squeue", {"--noheader", "--jobs=" + id});
            if (!queue.ok || queue.output.empty())
                break; // it is forgotten soon after its end
            QThread::msleep(betweenLooks);
        }
    }
    return isDone() ? ""
                    : "something is missing after " + std::to_string(mostArrays) +
                          " arrays of jobs: see the logs in " + order.folder.toStdString();
}

} // namespace bolster::cli
