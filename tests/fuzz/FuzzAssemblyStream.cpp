// What a reader of CAD and modelling files that has been taken over may send.
#include "AssemblyStream.h"
#include "TimedRun.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const bolster::test::TimedRun run;
    using namespace bolster;
    const std::string_view all(reinterpret_cast<const char*>(bytes), size);
    const std::size_t first = size > 0 ? bytes[size - 1] % size : 0;
    AssemblyStream whole, pieces;
    whole.take(all);
    pieces.take(all.substr(0, first));
    pieces.take(all.substr(first));
    if (whole.state() != pieces.state() || whole.warnings().size() != pieces.warnings().size())
        std::abort();
    const Assembly assembly = whole.takeAssembly();
    if (assembly.parts.size() != pieces.takeAssembly().parts.size())
        std::abort();
    for (std::size_t i = 0; i < assembly.parts.size(); ++i) {
        const Assembly::Part& part = assembly.parts[i];
        if (part.parent && *part.parent >= i)
            std::abort();
        for (const auto& triangle : part.triangles)
            for (const std::uint32_t corner : triangle)
                if (corner >= part.points.size())
                    std::abort();
    }
    return 0;
}
