#include "FuzzCloud.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    return bolster::fuzzCloud(bolster::readXyz, bytes, size);
}
