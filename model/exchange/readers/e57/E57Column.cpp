#include "E57Column.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace bolster {

namespace {

[[noreturn]] void refuseField(const E57Node& element, std::string_view attribute)
{
    refuseFile({},
               QT_TRANSLATE_NOOP("Message", "%1: the numbers of \"%2\" are not described as they must be: \"%3\""),
               {excerpt(element.name), excerpt(attribute)});
}

std::int64_t integerOr(const E57Node& element, std::string_view called, std::int64_t otherwise)
{
    const std::string_view text = element.attribute(called);
    const std::optional<std::int64_t> number = text.empty() ? otherwise : e57Integer(text);
    if (!number)
        refuseField(element, called);
    return *number;
}

double numberOr(const E57Node& element, std::string_view called, double otherwise)
{
    const std::string_view text = element.attribute(called);
    const std::optional<double> number = text.empty() ? otherwise : e57Number(text);
    if (!number)
        refuseField(element, called);
    return *number;
}

void describeIntegers(E57Field& field, const E57Node& element)
{
    using Limits = std::numeric_limits<std::int64_t>;
    field.least = integerOr(element, "minimum", Limits::min());
    const std::int64_t most = integerOr(element, "maximum", Limits::max());
    if (most < field.least)
        refuseField(element, "maximum");
    if (element.type() == "ScaledInteger") {
        field.scale = numberOr(element, "scale", 1);
        field.offset = numberOr(element, "offset", 0);
    }
    const std::uint64_t span = static_cast<std::uint64_t>(most) - static_cast<std::uint64_t>(field.least);
    field.bits = static_cast<int>(std::bit_width(span));
    field.range = {static_cast<double>(field.least) * field.scale + field.offset,
                   static_cast<double>(most) * field.scale + field.offset};
}

void describeFloats(E57Field& field, const E57Node& element)
{
    field.isFloat = true;
    field.bits = element.attribute("precision") == "single" ? 32 : 64;
    const std::optional<double> least = e57Number(element.attribute("minimum"));
    const std::optional<double> most = e57Number(element.attribute("maximum"));
    if (least && most)
        field.range = {*least, *most};
}

} // namespace

std::optional<E57Field> E57Field::of(const E57Node& element)
{
    E57Field field;
    field.name = element.name;
    if (element.type() == "Integer" || element.type() == "ScaledInteger")
        describeIntegers(field, element);
    else if (element.type() == "Float")
        describeFloats(field, element);
    else
        return std::nullopt;
    return field;
}

std::uint64_t E57Column::available(std::uint64_t limit) const
{
    if (m_field.bits == 0)
        return limit;
    return std::min<std::uint64_t>(limit, (8 * m_bytes.size() - m_bit) / static_cast<std::size_t>(m_field.bits));
}

/// Packed without gaps, the least bit first.
std::uint64_t E57Column::take()
{
    if (m_field.bits == 0)
        return 0;
    const std::size_t byte = m_bit / 8, shift = m_bit % 8;
    std::array<char, 9> raw{}; // 64 bits that begin within a byte
    m_bytes.copy(raw.data(), raw.size(), byte);
    std::uint64_t number = littleEndian<std::uint64_t>({raw.data(), 8}) >> shift;
    if (shift > 0)
        number |= std::uint64_t{static_cast<unsigned char>(raw[8])} << (64 - shift);
    m_bit += static_cast<std::size_t>(m_field.bits);
    return m_field.bits == 64 ? number : number & ((std::uint64_t{1} << m_field.bits) - 1);
}

double E57Column::next()
{
    const std::uint64_t raw = take();
    if (m_field.isFloat)
        return m_field.bits == 64 ? std::bit_cast<double>(raw)
                                  : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
    const auto number = static_cast<std::int64_t>(static_cast<std::uint64_t>(m_field.least) + raw);
    return static_cast<double>(number) * m_field.scale + m_field.offset;
}

std::size_t E57Column::compact()
{
    const std::size_t taken = m_bit / 8;
    if (taken < m_bytes.size() / 2) // else what waits long is moved again and again
        return m_bytes.size() - taken;
    m_bytes.erase(0, taken);
    m_bit %= 8;
    return m_bytes.size();
}

} // namespace bolster
