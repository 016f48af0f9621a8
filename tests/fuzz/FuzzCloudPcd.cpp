#include "CloudReaders.h"
#include "ReaderFuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    bolster::test::fuzzReader(bolster::readPcd, {reinterpret_cast<const char*>(bytes), size});
    return 0;
}
