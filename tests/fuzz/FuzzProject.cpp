#include "ProjectFuzz.h"
#include "TimedRun.h"

#include <QTemporaryDir>

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const bolster::test::TimedRun run;
    static const QTemporaryDir folder("/dev/shm/bolster-fuzz-XXXXXX");
    bolster::test::fuzzProject(folder.filePath("fuzzed.bolster"), {reinterpret_cast<const char*>(bytes), size});
    return 0;
}
