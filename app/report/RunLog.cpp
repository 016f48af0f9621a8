#include "RunLog.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <initializer_list>
#include <mutex>

#include <csignal>
#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

namespace bolster {

namespace {

constexpr std::size_t keptLines = 400;
constexpr std::size_t lineLength = 320; // bytes; longer ones are cut
constexpr std::size_t mostInFile = 1'000'000;
constexpr int mostFrames = 96;
constexpr qsizetype keptRuns = 5;

/// All of it is there before anything happens: a signal handler may not ask for memory.
struct Ring {
    std::array<std::array<char, lineLength>, keptLines> lines{};
    std::atomic<std::size_t> count{0};
    std::mutex turn; // of those who write; a signal handler does not wait for it
    int file = -1;
    std::size_t written = 0;
    std::array<char, 4096> crashPath{};
    std::array<char, 128> head{};
    std::array<char, 64 * 1024> stack{}; // of the handler: the program's own may be what has overflown
    QtMessageHandler before = nullptr;
};

Ring& ring()
{
    static Ring kept;
    return kept;
}

void put(int file, const char* text)
{
    std::size_t left = std::strlen(text);
    while (left > 0) {
        const ssize_t done = ::write(file, text, left);
        if (done <= 0)
            return;
        text += done;
        left -= static_cast<std::size_t>(done);
    }
}

void putNumber(int file, long long number)
{
    std::array<char, 24> digits{};
    auto at = digits.size() - 1;
    do {
        digits[--at] = static_cast<char>('0' + number % 10);
        number /= 10;
    } while (number > 0 && at > 0);
    put(file, &digits[at]);
}

const char* letterOf(QtMsgType type)
{
    switch (type) {
    case QtDebugMsg:
        return "debug";
    case QtInfoMsg:
        return "info";
    case QtWarningMsg:
        return "warning";
    case QtCriticalMsg:
        return "critical";
    default:
        return "fatal";
    }
}

void keepMessage(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    Ring& kept = ring();
    QByteArray line = QTime::currentTime().toString(QStringLiteral("HH:mm:ss.zzz ")).toLatin1();
    line += letterOf(type);
    line += ' ';
    if (context.category && std::strcmp(context.category, "default") != 0)
        line += QByteArray(context.category) + ' ';
    line += QString(text).replace(u'\n', u' ').toUtf8();
    line.truncate(lineLength - 2);
    line += '\n';
    {
        const std::scoped_lock turn(kept.turn);
        const std::size_t number = kept.count.load(std::memory_order_relaxed);
        auto& place = kept.lines[number % keptLines];
        std::memcpy(place.data(), line.constData(), static_cast<std::size_t>(line.size()) + 1);
        kept.count.store(number + 1, std::memory_order_release);
        if (kept.file >= 0 && kept.written < mostInFile) {
            put(kept.file, line.constData());
            kept.written += static_cast<std::size_t>(line.size());
        }
    }
    if (kept.before)
        kept.before(type, context, text);
}

/// Only what signal-safety(7) allows, and what glibc's backtrace does once it is loaded.
void writeCrash(int signal)
{
    const Ring& kept = ring();
    const int file = ::open(kept.crashPath.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file >= 0) {
        put(file, kept.head.data());
        put(file, "ended by signal ");
        putNumber(file, signal);
        put(file, "\n\nStack:\n");
        std::array<void*, mostFrames> frames{};
        ::backtrace_symbols_fd(frames.data(), ::backtrace(frames.data(), mostFrames), file);
        put(file, "\nLast messages:\n");
        const std::size_t count = kept.count.load(std::memory_order_acquire);
        for (std::size_t n = count - std::min(count, keptLines); n < count; ++n)
            put(file, kept.lines[n % keptLines].data());
        ::close(file);
    }
    ::raise(signal); // the handler is gone by now: what ends the program ends it
}

void catchCrashes()
{
    void* loaded[1];
    ::backtrace(loaded, 1); // loads what it needs, which a handler may not
    stack_t stack{};
    stack.ss_sp = ring().stack.data();
    stack.ss_size = ring().stack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = &writeCrash;
    action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND) | SA_NODEFER;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        ::sigaction(signal, &action, nullptr);
}

QString crashFile(const QString& folder)
{
    return QDir(folder).filePath(QStringLiteral("last-crash.txt"));
}

void removeOldRuns(const QDir& folder)
{
    const QFileInfoList runs = folder.entryInfoList({QStringLiteral("run-*.log")}, QDir::Files, QDir::Time);
    for (qsizetype i = keptRuns; i < runs.size(); ++i)
        QFile::remove(runs[i].filePath());
}

template <std::size_t Size>
void keepBytes(std::array<char, Size>& place, const QByteArray& bytes)
{
    const auto length = std::min(static_cast<std::size_t>(bytes.size()), Size - 1);
    std::memcpy(place.data(), bytes.constData(), length);
    place[length] = '\0';
}

} // namespace

QString runLogFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/log");
}

void beginRunLog(const QString& folder)
{
    Ring& kept = ring();
    const QDir place(folder);
    place.mkpath(QStringLiteral("."));
    removeOldRuns(place);
    const QString now = QDateTime::currentDateTime().toString(Qt::ISODate);
    keepBytes(kept.crashPath, QFile::encodeName(crashFile(folder)));
    keepBytes(kept.head,
              QStringLiteral("Bolster %1, started %2, ").arg(QCoreApplication::applicationVersion(), now).toUtf8());
    const QString file = place.filePath(QStringLiteral("run-%1.log").arg(QCoreApplication::applicationPid()));
    kept.file = ::open(QFile::encodeName(file).constData(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (kept.file >= 0)
        put(kept.file, (QByteArray(kept.head.data()) + '\n').constData());
    kept.before = qInstallMessageHandler(&keepMessage);
    catchCrashes();
}

QString runLogText()
{
    Ring& kept = ring();
    const std::scoped_lock turn(kept.turn);
    const std::size_t count = kept.count;
    QString text;
    for (std::size_t n = count - std::min(count, keptLines); n < count; ++n)
        text += QString::fromUtf8(kept.lines[n % keptLines].data());
    return text;
}

QString lastCrashText(const QString& folder)
{
    constexpr qint64 most = 400'000; // bytes
    QFile file(crashFile(folder));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString when = QFileInfo(file).lastModified().toString(Qt::ISODate);
    return when + u'\n' + QString::fromUtf8(file.read(most));
}

} // namespace bolster
