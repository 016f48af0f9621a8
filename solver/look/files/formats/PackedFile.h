// Several files in one: ZIP, as 3MF and USDZ are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bolster {

/// As zlib packs (RFC 1950). Throws std::runtime_error for more than 4 GB.
std::string zlibPacked(std::string_view bytes);

/// The same files give the same bytes: no clock is asked. For less than 4 GB in all.
class PackedFile {
public:
    /// The contents of each file begin at a multiple of `alignment` bytes.
    explicit PackedFile(std::uint32_t alignment = 1);

    /// `name`: with "/" between folders. Squeezed files are smaller; others can be used where they lie.
    void add(std::string_view name, std::string_view bytes, bool squeeze);
    /// All that was added.
    std::string bytes() &&;

private:
    struct Entry {
        std::string name;
        std::uint32_t checksum, packed, unpacked, offset;
        std::uint16_t method;
    };

    void appendCommon(const Entry& entry, std::string& to) const;

    std::uint32_t m_alignment;
    std::string m_bytes;
    std::vector<Entry> m_entries;
};

} // namespace bolster
