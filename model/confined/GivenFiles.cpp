#include "GivenFiles.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bolster {

MappedFile::MappedFile(int descriptor)
    : m_bytes(MAP_FAILED)
{
    struct stat info = {};
    if (::fstat(descriptor, &info) != 0 || info.st_size <= 0)
        return;
    m_size = static_cast<std::size_t>(info.st_size);
    m_bytes = ::mmap(nullptr, m_size, PROT_READ, MAP_PRIVATE, descriptor, 0);
}

MappedFile::~MappedFile()
{
    if (m_bytes != MAP_FAILED)
        ::munmap(m_bytes, m_size);
}

std::string_view MappedFile::view() const
{
    return m_bytes == MAP_FAILED ? std::string_view() : std::string_view(static_cast<char*>(m_bytes), m_size);
}

std::vector<GivenFile> givenFiles(int argc, char** argv, int first)
{
    std::vector<GivenFile> files;
    for (int i = first; i < argc; ++i) {
        GivenFile file;
        const char* const end = argv[i] + std::strlen(argv[i]);
        const auto [at, error] = std::from_chars(argv[i], end, file.descriptor);
        if (error != std::errc() || at == end || *at != '=' || file.descriptor <= STDERR_FILENO)
            continue;
        file.name.assign(at + 1, end);
        files.push_back(std::move(file));
    }
    return files;
}

Answer::Answer()
    : m_descriptor(::fcntl(STDOUT_FILENO, F_DUPFD, STDERR_FILENO + 1))
{
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    ::fcntl(m_descriptor, F_SETPIPE_SZ, 1 << 20); // fewer turns; where that is too much, it stays as it was
}

void Answer::write(std::string_view bytes) const
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            ::_exit(1);
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
}

void leaveEverything()
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody would stop it any more
    ::clearenv();
}

} // namespace bolster
