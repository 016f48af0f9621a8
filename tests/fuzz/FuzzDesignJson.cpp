#include "DesignFuzz.h"
#include "TimedRun.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const bolster::test::TimedRun run;
    bolster::test::fuzzDesign({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
