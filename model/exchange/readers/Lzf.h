// Decompression of LZF, as PCD files use it, a few numbers at a time.
#pragma once

#include "ByteReader.h"

namespace bolster {

/// Whether so many bytes may be what these unpack to.
bool lzfMayHold(std::uint64_t packedSize, std::uint64_t size);

/// Refuses the file when the packed bytes make no sense, or give too little.
class LzfReader {
public:
    LzfReader(FileBytes bytes, std::uint64_t start, std::uint64_t packedSize);

    std::uint64_t unpacked() const { return m_given; } ///< so many have been read or skipped
    void skip(std::uint64_t count) { take(nullptr, count); }
    template <class Number>
    Number read()
    {
        std::array<char, sizeof(Number)> raw;
        take(raw.data(), raw.size());
        if constexpr (std::endian::native == std::endian::big)
            std::reverse(raw.begin(), raw.end());
        return std::bit_cast<Number>(raw);
    }
    /// Refuses when there is more.
    void requireEnd() const;

private:
    [[noreturn]] void refuse() const;
    void take(char* to, std::uint64_t count);
    void unpackMore();
    void put(char byte) { m_recent[m_made++ % m_recent.size()] = byte; }

    ImportWatch m_watch;
    ByteReader m_packed;
    FilePlace m_start;
    std::uint64_t m_left; // packed bytes
    std::uint64_t m_steps = 0;
    std::uint64_t m_made = 0;             // unpacked bytes
    std::uint64_t m_given = 0;            // of them
    std::array<char, 1 << 14> m_recent{}; // copies reach back 8 KB, and one step makes less than 300 bytes
};

} // namespace bolster
