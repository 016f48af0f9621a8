// Small programs beside Bolster that meet files of unknown origin, so that whatever these do, they do it there.
#pragma once

#include "DiskFile.h"

#include <QStringList>

#include <chrono>
#include <functional>
#include <span>
#include <stop_token>
#include <string_view>

class QProcess;

namespace bolster {

/// The program of this installation, or that which this build makes in `folderInBuild`; "" when there is none.
QString helperProgram(const char* name, const char* folderInBuild);

struct HelperLimits {
    std::uint64_t memory = 0;          ///< bytes of address space, libraries included
    std::chrono::seconds processor{0}; ///< of processor time
    bool writesFiles = false;
};

/// A program that reads one file of unknown origin and says on its standard output what is in it.
struct HelperOrder {
    QString program;
    QStringList arguments{};
    HelperLimits limits{};
    std::chrono::milliseconds time{60'000}; ///< then it is killed
};

/// What has been understood of what it has said so far.
enum class HelperSpeech { Unfinished, Done, Nonsense };

enum class HelperEnd { Done, NotStarted, Stopped, TooLong, Died };

/// A file that lies beside the one that is read, and belongs to it.
struct HelperFile {
    DiskFile file;
    std::string name;
};
inline constexpr std::size_t mostHelperFiles = 16;

/// Runs it with `input` as its standard input, which it need not open and cannot mistake; of `beside` (at most
/// mostHelperFiles) each is open, too, and an argument "NUMBER=NAME" says as what. `hear` gets its words as they
/// come, a piece at a time, and must not trust them. The program is gone when this returns; `stop` ends it within
/// 50 ms.
HelperEnd runHelper(const HelperOrder& order, const DiskFile& input, std::span<const HelperFile> beside,
                    const std::stop_token& stop, const std::function<HelperSpeech(std::string_view words)>& hear);

/// Sentences for the ends that are none of the user's doing. In `notStarted` %1 is the program, in the others the
/// file.
struct HelperSentences {
    const char* notStarted;
    const char* tooLong;
    const char* died;
};
/// Empty when it is done or was stopped.
Message helperProblem(HelperEnd end, const HelperSentences& sentences, const std::string& program,
                      const std::string& file);

/// Before it is started: the limits, which hold for whatever runs in its place, and an empty environment but for
/// `temporaryFolder`, if there is one.
void confine(QProcess& process, const HelperLimits& limits, const QString& temporaryFolder = {});

} // namespace bolster
