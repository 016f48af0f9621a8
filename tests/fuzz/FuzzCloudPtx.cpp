#include "CloudReaders.h"
#include "ReaderFuzz.h"
#include "TimedRun.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const bolster::test::TimedRun run;
    bolster::test::fuzzReader(bolster::readPtx, {reinterpret_cast<const char*>(bytes), size});
    return 0;
}
