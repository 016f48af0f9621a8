#include "E57Table.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr std::size_t sectionHeader = 32, packetHeader = 4, dataHeader = 6; // bytes
constexpr std::size_t mostColumns = 10'000;
constexpr std::size_t mostWaiting = 64'000'000; // bytes

enum PacketType : unsigned char { IndexPacket = 0, DataPacket = 1, IgnoredPacket = 2 };

std::uint64_t wholeNumber(const E57Node& node, std::string_view attribute)
{
    const std::optional<std::int64_t> number = e57Integer(node.attribute(attribute));
    if (!number || *number < 0)
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: \"%2\" of the points is missing or no number of things"),
                   {std::string(attribute)});
    return static_cast<std::uint64_t>(*number);
}

[[noreturn]] void refusePacket(FilePlace place)
{
    refuseFile(place,
               QT_TRANSLATE_NOOP("Message", "%1: the file is damaged: a packet of points is not as it must be; "
                                            "export the scan anew"));
}

/// Only one way of packing is in the standard.
void requirePlainCodec(const E57Node& vector)
{
    const E57Node* const codecs = vector.child("codecs");
    if (!codecs)
        return;
    for (const E57Node& codec : codecs->children)
        for (const E57Node& part : codec.children)
            if (part.name != "inputs" && part.name != "bitPackCodec")
                refuseFile({},
                           QT_TRANSLATE_NOOP("Message", "%1: the points are packed by \"%2\", which cannot be "
                                                        "read; export the scan without an extension"),
                           {excerpt(part.name)});
}

} // namespace

E57Table::E57Table(E57Pages& ahead, const E57Node& vector)
    : m_count(wholeNumber(vector, "recordCount"))
{
    requirePlainCodec(vector);
    if (const E57Node* const prototype = vector.child("prototype"))
        findColumns(*prototype);
    m_columnOf.assign(m_fields.size(), unread);
    if (m_count == 0)
        return;
    m_start = ahead.logical(wholeNumber(vector, "fileOffset"));
    const std::string_view header = ahead.content(m_start, sectionHeader);
    const auto length = littleEndian<std::uint64_t>(header.substr(8));
    const auto data = littleEndian<std::uint64_t>(header.substr(16));
    if (header[0] != 1)
        refusePacket(ahead.place(m_start));
    ahead.require(m_start, length);
    m_end = m_start + length;
    m_at = ahead.logical(data);
    if (m_at < m_start + sectionHeader || m_at > m_end)
        refusePacket(ahead.place(m_start));
}

void E57Table::findColumns(const E57Node& prototype)
{
    for (const E57Node& element : prototype.children) {
        if (element.type() == "Structure" || element.type() == "Vector")
            findColumns(element);
        else
            m_fields.push_back(E57Field::of(element));
        if (m_fields.size() > mostColumns)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: more is described in it than a scan can have"));
    }
}

std::optional<E57Field> E57Table::field(std::string_view called) const
{
    for (const auto& found : m_fields)
        if (found && found->name == called)
            return found;
    return std::nullopt;
}

std::size_t E57Table::want(std::string_view called)
{
    std::size_t k = 0;
    while (!m_fields[k] || m_fields[k]->name != called)
        ++k;
    if (m_columnOf[k] == unread) {
        m_columnOf[k] = m_columns.size();
        m_columns.emplace_back(*m_fields[k]);
    }
    return m_columnOf[k];
}

bool E57Table::isConstant() const
{
    return std::ranges::all_of(m_columns, [](const E57Column& column) { return column.field().bits == 0; });
}

/// So that a count that is a lie is told before anything is done about it.
void E57Table::requireRecords(const E57Pages& pages) const
{
    std::uint64_t bits = 0;
    for (const E57Column& column : m_columns)
        bits += static_cast<std::uint64_t>(column.field().bits);
    if (bits == 0 || m_count > 8 * (m_end - m_at) / bits)
        refuseFile(pages.place(m_start), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
}

FilePlace E57Table::readPacket(E57Pages& pages)
{
    const FilePlace place = pages.place(m_at);
    if (m_end - m_at < packetHeader)
        refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
    const std::string_view header = pages.content(m_at, packetHeader);
    const auto type = static_cast<unsigned char>(header[0]);
    const std::size_t length = std::size_t{littleEndian<std::uint16_t>(header.substr(2))} + 1;
    if (type > IgnoredPacket || length < packetHeader || length > m_end - m_at)
        refusePacket(place);
    if (type == DataPacket)
        readData(pages.content(m_at, length), place);
    m_at += length;
    return place;
}

/// A length for each column, then what belongs to each.
void E57Table::readData(std::string_view packet, FilePlace place)
{
    if (packet.size() < dataHeader || littleEndian<std::uint16_t>(packet.substr(4)) != m_fields.size() ||
        packet.size() < dataHeader + 2 * m_fields.size())
        refusePacket(place);
    std::size_t at = dataHeader + 2 * m_fields.size();
    for (std::size_t k = 0; k < m_fields.size(); ++k) {
        const std::size_t length = littleEndian<std::uint16_t>(packet.substr(dataHeader + 2 * k));
        if (length > packet.size() - at)
            refusePacket(place);
        if (m_columnOf[k] != unread)
            m_columns[m_columnOf[k]].append(packet.substr(at, length));
        at += length;
    }
}

std::uint64_t E57Table::readyRecords(std::uint64_t limit) const
{
    for (const E57Column& column : m_columns)
        limit = column.available(limit);
    return limit;
}

void E57Table::forget(const E57Pages& pages)
{
    std::size_t waiting = 0;
    for (E57Column& column : m_columns)
        waiting += column.compact();
    if (waiting > mostWaiting)
        refuseFile(pages.place(m_at),
                   QT_TRANSLATE_NOOP("Message", "%1: numbers that belong to one point lie too far "
                                                "from each other; export the scan anew"));
}

} // namespace bolster
