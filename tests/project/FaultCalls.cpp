#include "FaultCalls.h"

#include <atomic>
#include <cerrno>
#include <dlfcn.h>
#include <unistd.h>

namespace bolster::test {
namespace {

std::atomic<int> callsLeft = -1; // until one fails; -1: none does
std::atomic<bool> stays = false;
std::atomic<bool> hasFailed = false;
std::atomic<int> failure = 0;

bool fails()
{
    if (callsLeft < 0)
        return false;
    if (callsLeft > 0) {
        --callsLeft;
        return false;
    }
    if (!stays)
        callsLeft = -1;
    hasFailed = true;
    errno = failure;
    return true;
}

/// The function of that name behind ours.
template <class Function>
Function behind(const char* name)
{
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

} // namespace

FaultCalls::FaultCalls(int at, int error, bool lasting)
{
    stays = lasting;
    hasFailed = false;
    failure = error;
    callsLeft = at;
}

FaultCalls::~FaultCalls()
{
    callsLeft = -1;
}

bool FaultCalls::failed() const
{
    return hasFailed;
}

} // namespace bolster::test

// Found before those of the C library, by it and by all other libraries.
extern "C" int fsync(int file)
{
    static const auto real = bolster::test::behind<int (*)(int)>("fsync");
    return bolster::test::fails() ? -1 : real(file);
}

extern "C" int fdatasync(int file)
{
    static const auto real = bolster::test::behind<int (*)(int)>("fdatasync");
    return bolster::test::fails() ? -1 : real(file);
}

extern "C" int rename(const char* from, const char* to) noexcept
{
    static const auto real = bolster::test::behind<int (*)(const char*, const char*)>("rename");
    return bolster::test::fails() ? -1 : real(from, to);
}
