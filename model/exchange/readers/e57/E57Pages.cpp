#include "E57Pages.h"

#include <array>

namespace bolster {

namespace {

using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

/// Table k moves a byte over k bytes that follow it, so that eight are done at once.
constexpr CrcTables makeCrcTables()
{
    constexpr std::uint32_t polynomial = 0x82F63B78; // reflected
    CrcTables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ ((crc & 1) != 0 ? polynomial : 0);
        tables[0][byte] = crc;
    }
    for (std::size_t k = 1; k < tables.size(); ++k)
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[k - 1][byte];
            tables[k][byte] = before >> 8 ^ tables[0][before & 0xff];
        }
    return tables;
}

constexpr CrcTables crcTables = makeCrcTables();

std::uint32_t bigEndian(std::string_view bytes)
{
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8 | static_cast<unsigned char>(bytes[i]);
    return number;
}

} // namespace

std::uint32_t crc32c(std::string_view bytes)
{
    std::uint32_t crc = 0xffffffff;
    for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
        const std::uint64_t eight = littleEndian<std::uint64_t>(bytes) ^ crc;
        crc = 0;
        for (std::size_t k = 0; k < 8; ++k)
            crc ^= crcTables[7 - k][eight >> 8 * k & 0xff];
    }
    for (const char byte : bytes)
        crc = crc >> 8 ^ crcTables[0][(crc ^ static_cast<unsigned char>(byte)) & 0xff];
    return ~crc;
}

E57Pages::E57Pages(const FileBytes& bytes)
    : m_bytes(bytes)
    , m_window(bytes)
    , m_size(bytes.size() / pageSize * contentSize)
{}

std::uint64_t E57Pages::logical(std::uint64_t physical) const
{
    const std::uint64_t page = physical / pageSize, within = physical % pageSize;
    const std::uint64_t at = page * contentSize + within;
    if (within >= contentSize || at >= m_size)
        refuseFile({},
                   QT_TRANSLATE_NOOP("Message", "%1: the file is damaged: something is said to be at byte %2, "
                                                "where nothing can be; copy it again, or export the scan anew"),
                   {std::to_string(physical)});
    return at;
}

FilePlace E57Pages::place(std::uint64_t logical) const
{
    return {FilePlace::Unit::Byte, logical / contentSize * pageSize + logical % contentSize};
}

void E57Pages::require(std::uint64_t logical, std::uint64_t count) const
{
    if (logical > m_size || count > m_size - logical)
        refuseFile(place(logical), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
}

std::string_view E57Pages::content(std::uint64_t logical, std::size_t count)
{
    require(logical, count);
    const std::uint64_t first = logical / contentSize, end = (logical + count + contentSize - 1) / contentSize;
    if (first < m_firstPage || first >= m_endPage) {
        m_content.clear();
        m_endPage = first;
    } else {
        m_content.erase(0, static_cast<std::size_t>((first - m_firstPage) * contentSize));
    }
    m_firstPage = first;
    while (m_endPage < end)
        addPage();
    return std::string_view(m_content).substr(static_cast<std::size_t>(logical - first * contentSize), count);
}

void E57Pages::addPage()
{
    const std::uint64_t at = m_endPage * pageSize;
    if (at < m_viewStart || at + pageSize > m_viewStart + m_view.size()) {
        m_view = m_window.view(at, pageSize);
        m_viewStart = at;
    }
    const std::string_view page = m_view.substr(static_cast<std::size_t>(at - m_viewStart), pageSize);
    const std::string_view held = page.substr(0, contentSize);
    if (crc32c(held) != bigEndian(page.substr(contentSize)))
        refuseFile({FilePlace::Unit::Byte, at},
                   QT_TRANSLATE_NOOP("Message", "%1: the file is damaged: a checksum is wrong; copy it again, or "
                                                "export the scan anew"));
    m_content.append(held);
    ++m_endPage;
}

} // namespace bolster
