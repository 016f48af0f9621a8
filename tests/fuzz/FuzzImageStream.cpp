// What a decoder of pictures that has been taken over may send, and the first look at a picture.
#include "ImageStream.h"
#include "TimedRun.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const bolster::test::TimedRun run;
    using namespace bolster;
    const std::string_view all(reinterpret_cast<const char*>(bytes), size);
    imageKindOf(all);
    jpegIsWhole(all);
    const std::size_t first = size > 0 ? bytes[0] % size : 0;
    ImageStreamReader whole, pieces;
    whole.take(all);
    pieces.take(all.substr(0, first));
    pieces.take(all.substr(first));
    if (whole.state() != pieces.state() || whole.takePixels() != pieces.takePixels())
        std::abort();
    return 0;
}
