// The pages of an E57 file (ASTM E2807): what they hold, without the checksums between it.
#pragma once

#include "FileBytes.h"

#include <string>

namespace bolster {

/// CRC-32C (Castagnoli's polynomial, reflected).
std::uint32_t crc32c(std::string_view bytes);

/// Logical offsets count what the pages hold, physical ones the bytes of the file. Throws FileRefused.
class E57Pages {
public:
    static constexpr std::uint64_t pageSize = 1024;
    static constexpr std::uint64_t contentSize = 1020; ///< of a page: the rest is its checksum

    explicit E57Pages(const FileBytes& bytes);

    /// Refuses an offset beyond the file, or in a checksum.
    std::uint64_t logical(std::uint64_t physical) const;
    FilePlace place(std::uint64_t logical) const;
    /// `count` bytes, or a refusal where the file ends or a checksum is wrong. Gone with the next call.
    std::string_view content(std::uint64_t logical, std::size_t count);
    /// Refuses when so many bytes are not there.
    void require(std::uint64_t logical, std::uint64_t count) const;
    const ImportWatch& watch() const { return m_bytes.watch(); }

private:
    void addPage();

    FileBytes m_bytes;
    FileWindow m_window;
    std::string_view m_view;
    std::uint64_t m_viewStart = 0;
    std::uint64_t m_size; ///< logical
    std::string m_content;
    std::uint64_t m_firstPage = 0, m_endPage = 0; ///< whose content that is
};

/// A number with the least byte first.
template <class Number>
Number littleEndian(std::string_view bytes)
{
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        number |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << 8 * i;
    return static_cast<Number>(number);
}

} // namespace bolster
