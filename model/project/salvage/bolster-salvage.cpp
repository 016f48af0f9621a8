// A process of its own that takes a damaged project apart: bolster-salvage COPY NAME OUT SECONDS. What came of it
// goes to the standard output. It may crash, hang or run out of memory; salvageProject() limits it and cleans up
// after it.
#include "Salvager.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sys/prctl.h>

int main(int argc, char** argv)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody would stop it any more
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (argc != 5)
        return 2;
    const auto path = [&](int i) { return QString::fromLocal8Bit(argv[i]); };
    const std::string bytes =
        bolster::bytesOf(bolster::salvageHere({path(1), path(2), path(3), std::atof(argv[4])}));
    return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0 ? 0 : 1;
}
