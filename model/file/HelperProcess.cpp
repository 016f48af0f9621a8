#include "HelperProcess.h"

#include <QDir>
#include <QFileInfo>
#include <QProcess>

#include <sys/resource.h>

namespace bolster {
namespace {

void limitTo(int resource, rlim_t most)
{
    const rlimit limit = {most, most};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/// Runs in the new process before the program does, so that no program can leave them out.
void setLimits(const HelperLimits& limits)
{
#ifndef __SANITIZE_ADDRESS__ // which reserves 16 TB
    limitTo(RLIMIT_AS, limits.memory);
#endif
    limitTo(RLIMIT_CPU, static_cast<rlim_t>(limits.processor.count()));
    if (!limits.writesFiles)
        limitTo(RLIMIT_FSIZE, 0);
    limitTo(RLIMIT_CORE, 0);
}

} // namespace

/// Not QCoreApplication::applicationDirPath(): the command line has no application object, and would look below
/// whatever folder it was started in.
QString helperProgram(const QString& name, const QString& ofThisBuild)
{
    const QString self = QFileInfo(QStringLiteral("/proc/self/exe")).symLinkTarget();
    const QString installed = QFileInfo(self).absolutePath() + QStringLiteral("/../libexec/bolster/") + name;
    for (const QString& program : {self.isEmpty() ? QString() : installed, ofThisBuild})
        if (!program.isEmpty() && QFileInfo(program).isExecutable())
            return QDir::cleanPath(program);
    return {};
}

void confine(QProcess& process, const HelperLimits& limits, const QString& temporaryFolder)
{
    QProcessEnvironment environment;
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8")); // one without any would be inherited
    if (!temporaryFolder.isEmpty())
        environment.insert(QStringLiteral("TMPDIR"), temporaryFolder);
    process.setProcessEnvironment(environment);
    process.setChildProcessModifier([limits] { setLimits(limits); });
}

} // namespace bolster
