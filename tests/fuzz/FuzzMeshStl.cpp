#include "FuzzMesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    return bolster::fuzzMesh(bolster::readStl, bytes, size);
}
