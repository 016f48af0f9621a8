#include "WholeFile.h"

#include "PosixFile.h"
#include "TemporaryFile.h"

#include <algorithm>
#include <cerrno>
#include <new>

// QSaveFile would do most of this, but it ignores the result of fsync, does not sync the folder (so a power cut
// may bring the old file back after "saved" was shown), and tells a full disk from a read-only folder only in the
// words of the operating system.

namespace bolster {

WholeFile readWholeFile(const QString& path, std::int64_t largest)
{
    const Descriptor file(path, O_RDONLY | O_NONBLOCK); // a pipe must not hold us up
    const auto info = file.valid() ? statusOf(file) : std::nullopt;
    if (!info)
        return {{}, readProblem(path, errno)};
    if (!S_ISREG(info->st_mode))
        return {{}, readProblem(path, S_ISDIR(info->st_mode) ? EISDIR : EINVAL)};
    if (info->st_size > largest)
        return {
            {},
            {QT_TRANSLATE_NOOP("Message", "\"%1\" is too large: %2 MB, and at most %3 MB are read"),
             {path.toStdString(), std::to_string(info->st_size / 1'000'000), std::to_string(largest / 1'000'000)}}};

    WholeFile result;
    try {
        result.bytes.resize(static_cast<std::size_t>(info->st_size));
    } catch (const std::bad_alloc&) {
        return {{}, readProblem(path, ENOMEM)};
    }
    std::size_t filled = 0;
    while (filled < result.bytes.size()) {
        const ssize_t got = ::read(file.get(), result.bytes.data() + filled, result.bytes.size() - filled);
        if (got < 0 && errno != EINTR)
            return {{}, readProblem(path, errno)};
        if (got == 0)
            break; // shortened meanwhile
        filled += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    result.bytes.resize(filled);
    return result;
}

Message replaceWholeFile(const QString& path, std::string_view bytes)
{
    const QString target = resolved(path);
    const auto present = statusOf(target);
    if (present)
        if (Message problem = protection(target, *present); !problem.empty())
            return problem;
    if (!present || S_ISREG(present->st_mode)) {
        TemporaryFile file(target);
        Message problem = file.write(bytes);
        return problem.empty() ? file.moveIntoPlace() : problem;
    }
    const Descriptor device(target, O_WRONLY);
    const int error = device.valid() ? writeAll(device, bytes) : errno;
    return error ? writeProblem(path, error) : Message{};
}

} // namespace bolster
