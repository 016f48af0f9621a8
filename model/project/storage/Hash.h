// 256 bits that tell two contents apart (BLAKE2b).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace bolster {

using Hash = std::array<std::uint8_t, 32>;

Hash hashOf(std::string_view bytes);
/// Hexadecimal.
std::string hexText(const Hash& hash);

inline std::string_view bytesOf(const Hash& hash)
{
    return {reinterpret_cast<const char*>(hash.data()), hash.size()};
}

/// The sum of the hashes of a set, whatever their order: what is added or taken away costs one addition.
class HashSum {
public:
    HashSum() = default;

    void add(const Hash& hash);
    void remove(const Hash& hash);
    Hash value() const;

private:
    std::array<std::uint64_t, 4> m_lanes = {};
};

} // namespace bolster
