#include "CborReader.h"

namespace bolster {
namespace {

constexpr int cborUnsigned = 0, cborText = 3, cborArray = 4, cborSimple = 7;
constexpr std::uint64_t cborNull = 22;

} // namespace

bool CborReader::head(Head& head)
{
    char first = 0;
    if (!m_bytes.read(&first, 1))
        return false;
    head = {static_cast<unsigned char>(first) >> 5, static_cast<std::uint64_t>(first & 31), false};
    if (head.number < 24)
        return true;
    if (head.number > 27) // of unknown length, or nothing that there is
        return false;
    head.wide = true;
    char bytes[8];
    const std::size_t count = std::size_t{1} << (head.number - 24);
    head.number = 0;
    if (!m_bytes.read(bytes, count))
        return false;
    for (std::size_t i = 0; i < count; ++i)
        head.number = head.number << 8 | static_cast<unsigned char>(bytes[i]);
    return true;
}

bool CborReader::array(std::uint64_t& length)
{
    Head found;
    if (!head(found) || found.kind != cborArray || found.number > m_bytes.left())
        return false;
    length = found.number;
    return true;
}

bool CborReader::characters(std::uint64_t count, std::string& text)
{
    if (count > m_bytes.left())
        return false;
    text.resize(static_cast<std::size_t>(count));
    return m_bytes.read(text.data(), text.size());
}

bool CborReader::text(std::string& text)
{
    Head found;
    return head(found) && found.kind == cborText && characters(found.number, text);
}

bool CborReader::optionalText(std::optional<std::string>& text)
{
    Head found;
    text.reset();
    if (!head(found))
        return false;
    if (found.kind == cborSimple)
        return found.number == cborNull && !found.wide;
    return found.kind == cborText && characters(found.number, text.emplace());
}

bool CborReader::id(ElementId& id)
{
    Head found;
    if (!head(found) || found.kind != cborUnsigned || found.number > static_cast<std::uint64_t>(largestElementId))
        return false;
    id = found.number == 0 ? settingsId : ElementId{static_cast<std::int32_t>(found.number)};
    return true;
}

} // namespace bolster
