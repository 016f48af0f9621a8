// Tries what a picture decoder that was taken over would try, and prints a line for each thing that worked. With
// "free" it tries the same outside of the sandbox.
#include "Sandbox.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

void say(const char* what, bool worked)
{
    if (worked)
        std::printf("%s\n", what);
}

bool forks()
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    return child > 0 && ::waitpid(child, nullptr, 0) == child;
}

} // namespace

int main(int argc, char** argv)
{
    const bool isFree = argc > 1 && std::strcmp(argv[1], "free") == 0;
    const int extra = ::open("/dev/null", O_WRONLY);
    if (!isFree && !bolster::enterSandbox())
        return 2;
    std::vector<char> memory(50'000'000, 'x'); // computing works
    struct stat info = {};
    say("read a file", ::open("/etc/passwd", O_RDONLY) >= 0);
    say("write a file", ::open("/tmp", O_TMPFILE | O_RDWR, 0600) >= 0);
    say("see a file", ::stat("/etc/passwd", &info) == 0);
    say("list the processes", ::open("/proc", O_RDONLY | O_DIRECTORY) >= 0);
    say("write to another open file", ::write(extra, "x", 1) == 1);
    say("open a socket", ::socket(AF_INET, SOCK_STREAM, 0) >= 0);
    say("open a local socket", ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
    say("start a process", forks());
    say("have memory that runs", ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED);
    say("signal its parent", ::kill(::getppid(), 0) == 0);
    std::fflush(stdout);
    if (!isFree) { // outside it would succeed, and end this
        ::execl("/bin/echo", "echo", "run a program", nullptr);
        ::_exit(errno == EPERM && memory.back() == 'x' ? 0 : 3); // looking for leaks is more than computing
    }
    return 0;
}
