#include "PlainBytes.h"

#include <zlib.h>

#include <cstring>

namespace bolster {
namespace {

constexpr std::size_t lengthBytes = 4;
constexpr std::uint64_t mostTimes = 1100; // deflate reaches 1032

} // namespace

std::optional<std::uint64_t> plainLength(std::string_view packed)
{
    if (packed.size() < lengthBytes)
        return std::nullopt;
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < lengthBytes; ++i)
        length = length << 8 | static_cast<unsigned char>(packed[i]);
    if (length > longestPlain || length > mostTimes * packed.size())
        return std::nullopt;
    return length;
}

PlainBytes PlainBytes::asTheyAre(std::string_view bytes)
{
    PlainBytes plain;
    plain.m_bytes = bytes;
    plain.m_left = bytes.size();
    return plain;
}

PlainBytes PlainBytes::unpacked(std::string_view packed)
{
    PlainBytes plain;
    const auto length = plainLength(packed);
    plain.m_stream.reset(new z_stream{});
    if (!length || ::inflateInit(plain.m_stream.get()) != Z_OK)
        return plain;
    packed.remove_prefix(lengthBytes);
    plain.m_stream->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data())); // zlib only reads it
    plain.m_stream->avail_in = static_cast<uInt>(packed.size());
    plain.m_left = *length;
    return plain;
}

PlainBytes::PlainBytes(PlainBytes&&) noexcept = default;
PlainBytes::~PlainBytes() = default;

void PlainBytes::Closer::operator()(z_stream_s* stream) const
{
    ::inflateEnd(stream);
    delete stream;
}

bool PlainBytes::read(char* to, std::size_t count)
{
    if (count > m_left)
        return false;
    m_left -= count;
    if (!m_stream) {
        std::memcpy(to, m_bytes.data(), count);
        m_bytes.remove_prefix(count);
        return true;
    }
    m_stream->next_out = reinterpret_cast<Bytef*>(to);
    m_stream->avail_out = static_cast<uInt>(count);
    while (m_stream->avail_out > 0)
        if (const int code = ::inflate(m_stream.get(), Z_SYNC_FLUSH); code != Z_OK)
            return code == Z_STREAM_END && m_stream->avail_out == 0;
    return true;
}

} // namespace bolster
