// Work on many machines: arrays of jobs for Slurm.
#pragma once

#include "Arguments.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <stop_token>
#include <string>

namespace bolster::cli {

struct SlurmOrder {
    QString folder;      ///< that all machines see: scripts and words of jobs go there
    QString name;        ///< of the jobs
    QStringList command; ///< of the program; what follows it is "--part I/N"
    int jobs = 4;        ///< of an array
    QStringList options; ///< more for sbatch

    /// For jobs of a subcommand of this program, whose other words are to be added; with what `--jobs` and
    /// `--sbatch` say.
    static SlurmOrder from(const Arguments& arguments, const QString& subcommand, const QString& folder);
};

/// Why no jobs can be submitted from here; empty where they can. To be asked before long work.
std::string whyNoSlurm();

/// Submits an array of jobs and waits for its end, until `isDone`: jobs that die or are killed leave something to
/// do, and another array does that; gives up after some. When stopped the jobs are cancelled. Returns what went
/// wrong, or an empty message.
std::string runOnSlurm(const SlurmOrder& order, const std::function<bool()>& isDone,
                       const std::function<void(const std::string&)>& say, const std::stop_token& stop);

} // namespace bolster::cli
