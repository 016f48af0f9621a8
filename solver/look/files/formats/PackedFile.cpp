// After PKWARE's APPNOTE.TXT 6.3, 4.3.7 (local headers), 4.3.12 (the directory), 4.3.16 (its end).
#include "PackedFile.h"

#include "RawNumbers.h"

#include <stdexcept>
#include <zlib.h>

namespace bolster {

namespace {

constexpr std::uint16_t utf8Names = 1U << 11;
constexpr std::uint16_t firstDay = 1U << 5 | 1U; ///< 1 January 1980
constexpr std::uint16_t padding = 0x1986;        ///< an extra field that says nothing

std::string squeezed(std::string_view bytes)
{
    z_stream stream{};
    if (deflateInit2(&stream, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("zlib");
    std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); // zlib does not write there
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    const int ended = deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    if (ended != Z_STREAM_END)
        throw std::runtime_error("zlib");
    return packed;
}

} // namespace

std::string zlibPacked(std::string_view bytes)
{
    auto size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    if (bytes.size() > 0xFFFF0000U ||
        compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  static_cast<uLong>(bytes.size()), 9) != Z_OK)
        throw std::runtime_error("zlib");
    packed.resize(size);
    return packed;
}

PackedFile::PackedFile(std::uint32_t alignment)
    : m_alignment(alignment)
{}

/// What local headers and the directory say alike, from the version on.
void PackedFile::appendCommon(const Entry& entry, std::string& to) const
{
    constexpr std::uint16_t version = 20; // the first with squeezed files and folders
    appendRaw(to, version);
    appendRaw(to, utf8Names);
    appendRaw(to, entry.method);
    appendRaw(to, std::uint16_t{0}); // midnight
    appendRaw(to, firstDay);
    appendRaw(to, entry.checksum);
    appendRaw(to, entry.packed);
    appendRaw(to, entry.unpacked);
    appendRaw(to, static_cast<std::uint16_t>(entry.name.size()));
}

void PackedFile::add(std::string_view name, std::string_view bytes, bool squeeze)
{
    constexpr std::size_t mostBytes = 0xFFFF0000U;
    const std::string packed = squeeze ? squeezed(bytes) : std::string(bytes);
    if (bytes.size() > mostBytes || m_bytes.size() + packed.size() > mostBytes)
        throw std::runtime_error("more than 4 GB");
    const auto* const raw = reinterpret_cast<const Bytef*>(bytes.data());
    m_entries.push_back({std::string(name),
                         static_cast<std::uint32_t>(crc32_z(0, raw, static_cast<z_size_t>(bytes.size()))),
                         static_cast<std::uint32_t>(packed.size()), static_cast<std::uint32_t>(bytes.size()),
                         static_cast<std::uint32_t>(m_bytes.size()), static_cast<std::uint16_t>(squeeze ? 8 : 0)});
    m_bytes += "PK\3\4";
    appendCommon(m_entries.back(), m_bytes);
    constexpr std::size_t fieldHead = 4;
    const std::size_t behindHead = m_bytes.size() + 2 + name.size();
    std::size_t gap = (m_alignment - behindHead % m_alignment) % m_alignment;
    if (gap > 0 && gap < fieldHead)
        gap += m_alignment;
    appendRaw(m_bytes, static_cast<std::uint16_t>(gap));
    m_bytes += name;
    if (gap > 0) {
        appendRaw(m_bytes, padding);
        appendRaw(m_bytes, static_cast<std::uint16_t>(gap - fieldHead));
        m_bytes.append(gap - fieldHead, '\0');
    }
    m_bytes += packed;
}

std::string PackedFile::bytes() &&
{
    const auto start = static_cast<std::uint32_t>(m_bytes.size());
    for (const Entry& entry : m_entries) {
        m_bytes += "PK\1\2";
        appendRaw(m_bytes, std::uint16_t{20}); // made by the same version
        appendCommon(entry, m_bytes);
        for (int unused = 0; unused < 4; ++unused) // extra field, comment, disk, what is text
            appendRaw(m_bytes, std::uint16_t{0});
        appendRaw(m_bytes, std::uint32_t{0});
        appendRaw(m_bytes, entry.offset);
        m_bytes += entry.name;
    }
    const auto size = static_cast<std::uint32_t>(m_bytes.size()) - start;
    const auto count = static_cast<std::uint16_t>(m_entries.size());
    m_bytes += "PK\5\6";
    appendRaw(m_bytes, std::uint32_t{0}); // one disk
    appendRaw(m_bytes, count);
    appendRaw(m_bytes, count);
    appendRaw(m_bytes, size);
    appendRaw(m_bytes, start);
    appendRaw(m_bytes, std::uint16_t{0});
    return std::move(m_bytes);
}

} // namespace bolster
