#include "Salvage.h"

#include "Database.h"
#include "HelperProcess.h"
#include "Salvager.h"
#include "Schema.h"
#include "SchemaRepair.h"
#include "TemporaryFile.h"
#include "Unfinished.h"
#include "WholeFile.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>

namespace bolster {
namespace {

constexpr std::int64_t largestProject = std::int64_t{1} << 40; // bytes
constexpr qsizetype fileHeadSize = 100;
constexpr std::size_t mostOtherTables = 50;
constexpr qsizetype longestAnswer = 16 << 20;

/// The head of a project file is the same in all of them but for these numbers, and so is the list of its tables:
/// damaged ones are written anew. False when nothing behind it can be right.
bool repairHead(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadWrite) || !file.resize(file.size() / pageSize * pageSize))
        return false;
    QByteArray page = file.read(pageSize);
    if (page.size() == pageSize)
        page = withRepairedSchema(page);
    if (page.size() < pageSize ||
        !tablesFitOnePage(std::string_view(page.constData() + fileHeadSize, pageSize - fileHeadSize),
                          mostOtherTables))
        return false;
    QByteArray head = page.first(fileHeadSize);
    const auto put = [&](qsizetype at, std::int64_t number) {
        for (int i = 3; i >= 0; --i, number >>= 8)
            head[at + i] = static_cast<char>(number);
    };
    head.replace(0, 16, QByteArray("SQLite format 3", 16));
    head.replace(16, 8, QByteArray("\x20\x00\x01\x01\x00\x40\x20\x20", 8));
    put(28, file.size() / pageSize);
    put(32, 0); // nothing is free: nothing will be written
    put(36, 0);
    put(44, 4);
    put(52, 0);
    put(56, 1);
    put(60, schemaVersion);
    put(64, 0);
    put(68, applicationId);
    head.replace(92, 4, head.mid(24, 4));
    page.replace(0, fileHeadSize, head);
    return file.seek(0) && file.write(page) == pageSize && file.flush();
}

/// A sound head that says nothing of us.
bool isOfAnotherProgram(const QString& path)
{
    QFile file(path);
    const QByteArray head = file.open(QIODevice::ReadOnly) ? file.read(fileHeadSize) : QByteArray();
    const auto isZero = [&](qsizetype at) { return head.mid(at, 4) == QByteArray(4, '\0'); };
    return head.size() == fileHeadSize && head.startsWith(QByteArray("SQLite format 3", 16)) && isZero(60) &&
           isZero(68);
}

Salvaged blamed(const Message& problem)
{
    return {problem, false, {}};
}

/// 512 MB and 20 times the file, and 10 s and 2 s for each MB: nothing that was a project takes as much.
HelperLimits limitsFor(std::int64_t bytes)
{
    const std::int64_t megabytes = bytes / 1'000'000;
    return {512'000'000 + 20 * static_cast<std::uint64_t>(bytes), std::chrono::seconds(10 + 2 * megabytes), true};
}

/// What the process says, or nothing when it died.
std::optional<Salvaged> run(QProcess& process, const std::stop_token& stop)
{
    constexpr int pollMilliseconds = 50;
    if (!process.waitForStarted())
        return Salvaged{
            {QT_TRANSLATE_NOOP("Message", "the program \"%1\", which recovers projects for Bolster, cannot "
                                          "be started; install Bolster again"),
             {process.program().isEmpty() ? "bolster-salvage" : process.program().toStdString()}},
            true,
            {}};
    QByteArray answer;
    while (process.state() != QProcess::NotRunning && answer.size() <= longestAnswer && !stop.stop_requested()) {
        process.waitForReadyRead(pollMilliseconds);
        answer += process.readAllStandardOutput();
    }
    if (answer.size() > longestAnswer || stop.stop_requested())
        process.kill();
    process.waitForFinished(-1);
    answer += process.readAllStandardOutput();
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return std::nullopt;
    return salvagedFrom({answer.constData(), static_cast<std::size_t>(answer.size())});
}

/// Brings into the copy what is in the log: SQLite takes it up to the first piece that is damaged.
void applyLog(const QString& log, const QString& copy)
{
    if (!copyWholeFile(log, copy + "-wal", largestProject).empty())
        return;
    (void)repairHead(copy); // else it is not looked at
    try {
        Database(copy, Database::Access::Working).run("PRAGMA wal_checkpoint(TRUNCATE)");
    } catch (const std::exception&) { // what is in the file itself is left
    }
    QFile::remove(copy + "-wal");
}

Salvaged salvageFile(const QString& damaged, const QString& out, const QString& log, const std::stop_token& stop)
{
    if (QFileInfo::exists(out))
        return {{QT_TRANSLATE_NOOP("Message", "there is a file \"%1\" already"), {out.toStdString()}}, true, {}};
    const WorkFolder folder;
    const QString copy = folder.filePath("damaged");
    if (const Message problem = copyWholeFile(damaged, copy, largestProject); !problem.empty())
        return blamed(problem);
    if (isOfAnotherProgram(copy))
        return blamed({QT_TRANSLATE_NOOP("Message", "\"%1\" is no Bolster project"), {damaged.toStdString()}});
    if (!log.isEmpty())
        applyLog(log, copy);
    if (!repairHead(copy))
        return blamed({QT_TRANSLATE_NOOP("Message", "nothing in \"%1\" can be saved"), {damaged.toStdString()}});

    const HelperLimits limits = limitsFor(QFileInfo(copy).size());
    const double seconds = 0.8 * static_cast<double>(limits.processor.count()); // the rest is for the new file
    QProcess process;
    process.setProgram(helperProgram("bolster-salvage", "model/project"));
    process.setArguments({copy, damaged, QFileInfo(out).absoluteFilePath(), QString::number(seconds)});
    process.setStandardErrorFile(QProcess::nullDevice());
    confine(process, limits, folder.path());
    process.start(QIODevice::ReadOnly);
    if (std::optional<Salvaged> salvaged = run(process, stop))
        return std::move(*salvaged);
    removeLeftTemporaryFiles(QFileInfo(out).absolutePath());
    if (stop.stop_requested())
        return {{QT_TRANSLATE_NOOP("Message", "interrupted"), {}}, true, {}};
    return blamed(
        {QT_TRANSLATE_NOOP("Message", "nothing in \"%1\" can be saved: it is damaged in a way that takes too "
                                      "much time or memory"),
         {damaged.toStdString()}});
}

} // namespace

Salvaged salvageProject(const QString& damaged, const QString& out, const std::stop_token& stop)
{
    return salvageFile(damaged, out, {}, stop);
}

Salvaged salvageJournal(const QString& damaged, const QString& out, const std::stop_token& stop)
{
    return salvageFile(damaged, out, damaged + "-wal", stop);
}

} // namespace bolster
