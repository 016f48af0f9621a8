// Decompression of LZF, as PCD files use it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bolster {

/// Nothing when the bytes do not unpack to exactly `size` bytes.
std::optional<std::string> unpackLzf(std::string_view packed, std::uint64_t size);

} // namespace bolster
