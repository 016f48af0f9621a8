// Without checksums: what comes in is what the pages hold, or everything behind the first check would be out of
// reach.
#include "CloudReaders.h"
#include "E57Writer.h"
#include "ReaderFuzz.h"
#include "TimedRun.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const std::string file = bolster::test::e57Pages({reinterpret_cast<const char*>(bytes), size});
    const bolster::test::TimedRun run;
    bolster::test::fuzzReader(bolster::readE57, file);
    return 0;
}
