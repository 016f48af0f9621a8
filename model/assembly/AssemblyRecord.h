// How the records of an assembly's stream begin, for its writer and its reader, which are of one build.
#pragma once

#include <cstdint>

namespace bolster {

inline constexpr std::uint32_t assemblyMark = 0x31414C42; ///< "BLA1": how the stream begins

enum class AssemblyRecord : std::uint32_t {
    Facts,     ///< double mm per unit (0: not said), word up (0: not said, else UpAxis + 1)
    Part,      ///< word parent + 1 (0: none), word colour (or noColor), name
    Points,    ///< word part, doubles
    Triangles, ///< word part, words: points of the part so far
    Edge,      ///< word part, word kind, doubles
    Warning,   ///< word oddity, double count, text
    Progress,  ///< double, 0 to 1
    End,       ///< word verdict, text
};

/// Then follow the bytes of the record.
struct AssemblyRecordHead {
    std::uint32_t kind = 0;
    std::uint32_t size = 0;
};

inline constexpr std::uint32_t noColor = 0xFFFFFFFF;
inline constexpr std::uint32_t largestAssemblyRecord = 1 << 20; ///< bytes

} // namespace bolster
