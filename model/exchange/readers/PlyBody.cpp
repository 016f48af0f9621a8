#include "PlyBody.h"

namespace bolster {

PlyBody::PlyBody(const PlyHeader& header, const FileBytes& bytes, TextScanner& text)
    : m_bytes(bytes)
    , m_isText(header.format == PlyHeader::Format::Text)
    , m_text(text)
    , m_binary(bytes, header.format == PlyHeader::Format::BigEndian, m_isText ? 0 : text.offsetOfNextLine())
{
    for (const PlyElement& element : header.elements)
        m_rows += element.properties.empty() ? 0 : element.count;
}

void PlyBody::warnOfSurplus() const
{
    if (m_surplus && m_bytes.watch().warn)
        m_bytes.watch().warn(QT_TRANSLATE_NOOP("Message",
                                               "%1: the rows hold more than the header of the file says; "
                                               "what is too much in each was left out"),
                             {});
}

/// A file that is not written line by line may have several rows on one.
bool PlyBody::rowsHaveLines()
{
    if (!m_rowsHaveLines) {
        TextScanner again(m_bytes);
        readPlyHeader(again);
        std::uint64_t lines = 0;
        while (lines < m_rows && again.nextLine())
            ++lines;
        m_rowsHaveLines = lines >= m_rows;
    }
    return *m_rowsHaveLines;
}

void PlyBody::require(std::uint64_t rows, std::uint64_t binaryBytesPerRow, std::uint64_t wordsPerRow) const
{
    const std::uint64_t left = m_isText ? m_text.bytesLeft() + 1 : m_binary.bytesLeft();
    const std::uint64_t perRow = m_isText ? 2 * wordsPerRow : binaryBytesPerRow;
    if (perRow > 0 && rows > left / perRow)
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
}

void PlyBody::requireRows(const PlyElement& element) const
{
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += byteSize(property.countType.value_or(property.type));
    require(element.count, bytes, element.properties.size());
}

std::int64_t PlyBody::integer(PlyType type)
{
    return m_isText ? m_text.integer(m_text.wordOnAnyLine()) : static_cast<std::int64_t>(binaryNumber(type));
}

std::uint64_t PlyBody::listSize(const PlyProperty& property)
{
    const std::int64_t size = integer(*property.countType);
    if (size < 0)
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: a count is negative"));
    require(static_cast<std::uint64_t>(size), byteSize(property.type), 1);
    return static_cast<std::uint64_t>(size);
}

void PlyBody::skip(const PlyProperty& property)
{
    const std::uint64_t size = property.countType ? listSize(property) : 1;
    for (std::uint64_t i = 0; i < size; ++i)
        number(property.type);
}

void PlyBody::skip(const PlyElement& element)
{
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        for (const PlyProperty& property : element.properties)
            skip(property);
        endRow();
    }
}

/// Which coordinate each property is, or -1.
std::vector<int> PlyBody::axes(const PlyElement& element)
{
    constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
    std::vector<int> axisOf(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view name = names[static_cast<std::size_t>(axis)];
        const auto property = element.find(name);
        if (!property || element.properties[*property].countType)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: the points have no coordinate \"%2\""),
                       {std::string(name)});
        axisOf[*property] = axis;
    }
    return axisOf;
}

std::vector<int> PlyBody::colorShifts(const PlyElement& element)
{
    std::vector<int> shifts(element.properties.size(), -1);
    const auto red = element.find("red", "diffuse_red"), green = element.find("green", "diffuse_green"),
               blue = element.find("blue", "diffuse_blue");
    const auto isByte = [&](const std::optional<std::size_t>& k) {
        return k && !element.properties[*k].countType && element.properties[*k].type == PlyType::Uint8;
    };
    if (isByte(red) && isByte(green) && isByte(blue)) {
        shifts[*red] = 16;
        shifts[*green] = 8;
        shifts[*blue] = 0;
    }
    return shifts;
}

double PlyBody::binaryNumber(PlyType type)
{
    switch (type) {
    case PlyType::Int8:
        return m_binary.read<std::int8_t>();
    case PlyType::Uint8:
        return m_binary.read<std::uint8_t>();
    case PlyType::Int16:
        return m_binary.read<std::int16_t>();
    case PlyType::Uint16:
        return m_binary.read<std::uint16_t>();
    case PlyType::Int32:
        return m_binary.read<std::int32_t>();
    case PlyType::Uint32:
        return m_binary.read<std::uint32_t>();
    case PlyType::Float32:
        return static_cast<double>(m_binary.read<float>());
    case PlyType::Float64:
        break;
    }
    return m_binary.read<double>();
}

} // namespace bolster
