// Bytes that somebody else has packed, a piece at a time. Private to the library.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct z_stream_s;

namespace bolster {

/// Of what lies in a project unpacked: nothing that Bolster writes is longer.
inline constexpr std::uint64_t longestPlain = 64u << 20; // bytes

/// How many bytes come out of packed ones (qCompress: their number, the highest byte first, and a zlib stream), as
/// they claim. Nothing when that cannot be, or is more than longestPlain.
std::optional<std::uint64_t> plainLength(std::string_view packed);

/// Packed bytes are unpacked only as far as somebody reads, so that those that promise much are refused by their
/// first few.
class PlainBytes {
public:
    static PlainBytes asTheyAre(std::string_view bytes);
    static PlainBytes unpacked(std::string_view packed);
    ~PlainBytes();
    PlainBytes(PlainBytes&&) noexcept;

    /// Fills `to`, or is false: so many are not there.
    bool read(char* to, std::size_t count);
    /// How many are left, as far as anybody knows.
    std::uint64_t left() const { return m_left; }
    /// Whether all that was claimed was there, and has been read.
    bool atEnd() const { return m_left == 0; }

private:
    PlainBytes() = default;

    struct Closer {
        void operator()(z_stream_s* stream) const;
    };
    std::string_view m_bytes;
    std::uint64_t m_left = 0;
    std::unique_ptr<z_stream_s, Closer> m_stream; // of packed ones
};

} // namespace bolster
