#include "Sandbox.h"

#include <algorithm>
#include <cerrno>
#include <initializer_list>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace bolster {
namespace {

bool allow(scmp_filter_ctx filter, int call)
{
    return ::seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) == 0;
}

bool allowWith(scmp_filter_ctx filter, int call, scmp_arg_cmp argument)
{
    return ::seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, 1, &argument) == 0;
}

/// Memory, but none that could be run as a program; the clock; reading; ending.
bool addRules(scmp_filter_ctx filter, std::span<const int> kept)
{
    bool good = true;
    for (const int call : {SCMP_SYS(read),
                           SCMP_SYS(pread64),
                           SCMP_SYS(readv),
                           SCMP_SYS(lseek),
                           SCMP_SYS(fstat),
                           SCMP_SYS(close),
                           SCMP_SYS(brk),
                           SCMP_SYS(munmap),
                           SCMP_SYS(mremap),
                           SCMP_SYS(madvise),
                           SCMP_SYS(futex),
                           SCMP_SYS(rt_sigaction),
                           SCMP_SYS(rt_sigprocmask),
                           SCMP_SYS(rt_sigreturn),
                           SCMP_SYS(sigaltstack),
                           SCMP_SYS(getpid),
                           SCMP_SYS(gettid),
                           SCMP_SYS(sched_yield),
                           SCMP_SYS(sched_getaffinity),
                           SCMP_SYS(clock_gettime),
                           SCMP_SYS(gettimeofday),
                           SCMP_SYS(getrandom),
                           SCMP_SYS(exit),
                           SCMP_SYS(exit_group)})
        good = allow(filter, call) && good;
    for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)})
        good = allowWith(filter, call, SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0)) && good;
    std::vector<int> written = {STDOUT_FILENO, STDERR_FILENO};
    written.insert(written.end(), kept.begin(), kept.end());
    for (const int call : {SCMP_SYS(write), SCMP_SYS(writev)})
        for (const int file : written)
            good = allowWith(filter, call, SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(file))) && good;
    // How the C library asks for the size of an open file: by an empty path.
    good = allowWith(filter, SCMP_SYS(newfstatat), SCMP_A3(SCMP_CMP_EQ, 0x1000 /* AT_EMPTY_PATH */)) && good;
    // What abort() needs to end this process.
    good = allowWith(filter, SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid()))) && good;
    return good;
}

/// Systems that do not know the call keep all open.
void closeAllBut(std::span<const int> kept)
{
    std::vector<int> sorted(kept.begin(), kept.end());
    std::ranges::sort(sorted);
    unsigned from = STDERR_FILENO + 1;
    for (const int file : sorted) {
        const auto next = static_cast<unsigned>(file);
        if (next > from)
            ::syscall(SYS_close_range, from, next - 1, 0U);
        from = std::max(from, next + 1);
    }
    ::syscall(SYS_close_range, from, ~0U, 0U);
}

} // namespace

bool enterSandbox(std::span<const int> kept)
{
    closeAllBut(kept);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    const scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ERRNO(EPERM));
    if (!filter)
        return false;
    const bool good = addRules(filter, kept) && ::seccomp_load(filter) == 0;
    ::seccomp_release(filter);
    return good;
}

} // namespace bolster
