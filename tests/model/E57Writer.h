// E57 files as tests need them: right ones, and wrong ones on purpose. Shares nothing with the reader.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace bolster::test {

/// Bit by bit.
inline std::uint32_t slowCrc32c(const std::string& bytes)
{
    std::uint32_t crc = 0xffffffff;
    for (const char byte : bytes)
        for (int bit = 0; bit < 8; ++bit) {
            const bool out = ((crc ^ static_cast<unsigned char>(byte) >> bit) & 1) != 0;
            crc = crc >> 1 ^ (out ? 0x82F63B78 : 0);
        }
    return ~crc;
}

/// The content of pages with a checksum behind every 1020 bytes.
inline std::string e57Pages(std::string content)
{
    content.resize((content.size() + 1019) / 1020 * 1020);
    std::string file;
    for (std::size_t at = 0; at < content.size(); at += 1020) {
        const std::string page = content.substr(at, 1020);
        const std::uint32_t crc = slowCrc32c(page);
        file += page;
        for (const int shift : {24, 16, 8, 0})
            file += static_cast<char>(crc >> shift & 0xff);
    }
    return file;
}

inline std::uint64_t e57Physical(std::uint64_t logical)
{
    return logical / 1020 * 1024 + logical % 1020;
}

/// A column of the table of points: its element, and its records as they are packed.
struct E57TestColumn {
    std::string element;
    int bits = 0;
    std::vector<std::uint64_t> records;

    /// In bytes, the least bit first.
    std::string packed() const
    {
        std::string bytes;
        std::size_t used = 0;
        for (const std::uint64_t record : records)
            for (int bit = 0; bit < bits; ++bit, ++used) {
                if (used % 8 == 0)
                    bytes += '\0';
                if ((record >> bit & 1) != 0)
                    bytes.back() = static_cast<char>(bytes.back() | 1 << used % 8);
            }
        return bytes;
    }
};

inline E57TestColumn e57Doubles(const std::string& name, const std::vector<double>& numbers)
{
    E57TestColumn column{"<" + name + " type=\"Float\"/>", 64, {}};
    for (const double number : numbers)
        column.records.push_back(std::bit_cast<std::uint64_t>(number));
    return column;
}

inline E57TestColumn e57Singles(const std::string& name, const std::vector<double>& numbers)
{
    E57TestColumn column{"<" + name + " type=\"Float\" precision=\"single\"/>", 32, {}};
    for (const double number : numbers)
        column.records.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(number)));
    return column;
}

/// `more`: attributes such as scale and offset, which make it a ScaledInteger.
inline E57TestColumn e57Integers(const std::string& name, std::int64_t least, std::int64_t most,
                                 const std::vector<std::int64_t>& numbers, const std::string& more = {})
{
    std::ostringstream element;
    element << "<" << name << " type=\"" << (more.empty() ? "Integer" : "ScaledInteger") << "\" minimum=\"" << least
            << "\" maximum=\"" << most << "\" " << more << "/>";
    E57TestColumn column{element.str(), 0, {}};
    for (std::uint64_t span = static_cast<std::uint64_t>(most) - static_cast<std::uint64_t>(least); span > 0;
         span /= 2)
        ++column.bits;
    for (const std::int64_t number : numbers)
        column.records.push_back(static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(least));
    return column;
}

class E57Writer {
public:
    /// `more` is written before the points: pose, limits.
    void addScan(const std::vector<E57TestColumn>& columns, std::size_t count, const std::string& more = {})
    {
        const std::uint64_t start = m_content.size();
        addSection(columns);
        m_scans << "<vectorChild type=\"Structure\">" << more << "<points type=\"CompressedVector\" fileOffset=\""
                << e57Physical(start) << "\" recordCount=\"" << count << "\"><prototype type=\"Structure\">";
        for (const E57TestColumn& column : columns)
            m_scans << column.element;
        m_scans << "</prototype><codecs type=\"Vector\" allowHeterogeneousChildren=\"1\"></codecs></points>"
                << "</vectorChild>\n";
    }
    void addScan(const std::vector<E57TestColumn>& columns) { addScan(columns, columns.front().records.size()); }

    /// Without checksums.
    std::string content() const
    {
        const std::string tree = head + m_scans.str() + "</data3D></e57Root>\n";
        std::string all = m_content + tree;
        const std::uint64_t pages = (all.size() + 1019) / 1020;
        std::string header = "ASTM-E57";
        append(header, std::uint32_t{1});
        append(header, std::uint32_t{0});
        append(header, 1024 * pages);
        append(header, e57Physical(m_content.size()));
        append(header, static_cast<std::uint64_t>(tree.size()));
        append(header, std::uint64_t{1024});
        return all.replace(0, header.size(), header);
    }
    std::string file() const { return e57Pages(content()); }

    std::string head = R"(<?xml version="1.0" encoding="UTF-8"?>
<e57Root type="Structure" xmlns="http://www.astm.org/COMMIT/E57/2010-e57-v1.0">
<formatName type="String"><![CDATA[ASTM E57 3D Imaging Data File]]></formatName>
<guid type="String"><![CDATA[{0-1}]]></guid><versionMajor type="Integer">1</versionMajor><versionMinor type="Integer"/>
<data3D type="Vector" allowHeterogeneousChildren="1">
)";
    /// Bytes of each column in a packet: other columns have other shares, so that a packet holds no whole records.
    std::size_t bytesPerPacket = 50;

private:
    template <class Number>
    static void append(std::string& bytes, Number number)
    {
        for (std::size_t i = 0; i < sizeof(Number); ++i)
            bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> 8 * i & 0xff);
    }

    void addSection(const std::vector<E57TestColumn>& columns)
    {
        std::string packets(16, '\0'); // an index, which says nothing
        packets[2] = 15;
        std::vector<std::string> left;
        for (const E57TestColumn& column : columns)
            left.push_back(column.packed());
        for (bool more = true; more;) {
            more = false;
            std::vector<std::string> pieces;
            for (std::size_t k = 0; k < left.size(); ++k) {
                pieces.push_back(left[k].substr(0, bytesPerPacket + k));
                left[k].erase(0, pieces.back().size());
                more = more || !left[k].empty();
            }
            packets += dataPacket(pieces);
            packets += std::string("\x02\0\x07\0\0\0\0\0", 8); // one that is to be ignored
        }
        const std::uint64_t start = m_content.size();
        std::string section(8, '\0');
        section[0] = 1;
        append(section, static_cast<std::uint64_t>(32 + packets.size()));
        append(section, e57Physical(start + 32));
        append(section, e57Physical(start + 32));
        m_content += section + packets;
    }

    static std::string dataPacket(const std::vector<std::string>& pieces)
    {
        std::string body;
        append(body, static_cast<std::uint16_t>(pieces.size()));
        for (const std::string& piece : pieces)
            append(body, static_cast<std::uint16_t>(piece.size()));
        for (const std::string& piece : pieces)
            body += piece;
        body.resize((body.size() + 3) / 4 * 4);
        std::string packet(2, '\0');
        packet[0] = 1;
        append(packet, static_cast<std::uint16_t>(body.size() + 3));
        return packet + body;
    }

    std::string m_content = std::string(48, '\0');
    std::ostringstream m_scans;
};

} // namespace bolster::test
