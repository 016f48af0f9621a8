// Meshes as scans: the first byte says which format.
#include "CloudReaders.h"
#include "ReaderFuzz.h"
#include "TimedRun.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    if (size == 0)
        return 0;
    constexpr std::array readers = {bolster::readObjScan, bolster::readPlyScan, bolster::readStlScan,
                                    bolster::readOffScan};
    const bolster::test::TimedRun run;
    bolster::test::fuzzReader(readers[bytes[0] % readers.size()],
                              {reinterpret_cast<const char*>(bytes) + 1, size - 1});
    return 0;
}
