#include "HelperProcess.h"

#include "ProgramPlace.h"
#include "Sanitizer.h"

#include <QFileInfo>
#include <QProcess>

#include <algorithm>
#include <array>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

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
#ifndef BOLSTER_ADDRESS_SANITIZER // which reserves 16 TB
    limitTo(RLIMIT_AS, limits.memory);
#endif
    limitTo(RLIMIT_CPU, static_cast<rlim_t>(limits.processor.count()));
    if (!limits.writesFiles)
        limitTo(RLIMIT_FSIZE, 0);
    limitTo(RLIMIT_CORE, 0);
}

constexpr int pollMilliseconds = 20;
constexpr int firstBeside = 1000; // below are the pipes that tell whether the program has been started

/// In the new process, where only calls are allowed that signal handlers may make.
void handOver(int input, const std::array<int, mostHelperFiles>& beside, std::size_t count)
{
    ::dup2(input, STDIN_FILENO);
    for (std::size_t i = 0; i < count; ++i)
        ::dup2(beside[i], firstBeside + static_cast<int>(i));
}

void prepare(QProcess& process, const HelperOrder& order, const DiskFile& input, std::span<const HelperFile> beside)
{
    QStringList arguments = order.arguments;
    std::array<int, mostHelperFiles> descriptors{};
    const std::size_t count = std::min(beside.size(), mostHelperFiles);
    for (std::size_t i = 0; i < count; ++i) {
        descriptors[i] = beside[i].file.descriptor();
        arguments << QStringLiteral("%1=").arg(firstBeside + static_cast<int>(i)) +
                         QString::fromStdString(beside[i].name);
    }
    process.setProgram(order.program);
    process.setArguments(arguments);
    process.setStandardInputFile(QProcess::nullDevice());
    process.setStandardErrorFile(QProcess::nullDevice());
    confine(process, order.limits);
    process.setChildProcessModifier([limits = order.limits, descriptors, count, input = input.descriptor()] {
        setLimits(limits);
        handOver(input, descriptors, count);
    });
}

} // namespace

QString helperProgram(const char* name, const char* folderInBuild)
{
    const QString program = QString::fromStdString(shippedFile(name, folderInBuild).string());
    return QFileInfo(program).isExecutable() ? program : QString();
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

HelperEnd runHelper(const HelperOrder& order, const DiskFile& input, std::span<const HelperFile> beside,
                    const std::stop_token& stop, const std::function<HelperSpeech(std::string_view words)>& hear)
{
    QProcess process;
    prepare(process, order, input, beside);
    process.start(QIODevice::ReadOnly);
    const auto end = std::chrono::steady_clock::now() + order.time;
    const auto endedBy = [&](HelperEnd how) {
        process.kill();
        process.waitForFinished();
        return how;
    };
    if (!process.waitForStarted())
        return HelperEnd::NotStarted;
    for (;;) {
        process.waitForReadyRead(pollMilliseconds);
        const QByteArray bytes = process.readAllStandardOutput();
        const HelperSpeech heard = hear({bytes.data(), static_cast<std::size_t>(bytes.size())});
        if (heard == HelperSpeech::Done)
            return endedBy(HelperEnd::Done);
        if (stop.stop_requested())
            return endedBy(HelperEnd::Stopped);
        if (heard == HelperSpeech::Nonsense || (bytes.isEmpty() && process.state() == QProcess::NotRunning))
            return endedBy(HelperEnd::Died);
        if (std::chrono::steady_clock::now() > end)
            return endedBy(HelperEnd::TooLong);
    }
}

Message helperProblem(HelperEnd end, const HelperSentences& sentences, const std::string& program,
                      const std::string& file)
{
    switch (end) {
    case HelperEnd::NotStarted:
        return {sentences.notStarted, {program}};
    case HelperEnd::TooLong:
        return {sentences.tooLong, {file}};
    case HelperEnd::Died:
        return {sentences.died, {file}};
    case HelperEnd::Done:
    case HelperEnd::Stopped:
        break;
    }
    return {};
}

} // namespace bolster
