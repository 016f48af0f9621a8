#include "DxfGroups.h"

#include "DrawnWords.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace bolster {

namespace {

constexpr std::size_t mostGroups = 12'000'000;
constexpr double largestDxfNumber = 1e12;
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view binarySentinel("AutoCAD Binary DXF\r\n\x1a\0", 22);

class TextGroups : public DxfGroups {
public:
    TextGroups(std::string_view text, const ImportWatch& watch)
        : m_text(text)
        , m_watch(watch)
    {
        if (m_text.starts_with(byteOrderMark))
            m_text.remove_prefix(byteOrderMark.size());
    }

    bool next(DxfGroup& group) override
    {
        std::string_view code;
        do {
            if (!line(code))
                return false;
        } while (code.empty());
        const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
        if (error != std::errc() || end != code.data() + code.size())
            refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a group code of DXF"),
                       {excerpt(code)});
        if (!line(group.words))
            refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: the file ends in the middle of something"));
        group.number.reset();
        count(m_watch, static_cast<double>(m_at) / static_cast<double>(m_text.size()));
        return true;
    }

    FilePlace place() const override { return {FilePlace::Unit::Line, m_line}; }

private:
    bool line(std::string_view& found)
    {
        if (m_at >= m_text.size())
            return false;
        const std::size_t end = std::min(m_text.find_first_of("\r\n", m_at), m_text.size());
        found = m_text.substr(m_at, end - m_at);
        m_at = end + 1;
        if (end + 1 < m_text.size() && m_text[end] == '\r' && m_text[end + 1] == '\n')
            ++m_at;
        ++m_line;
        found = trimmed(found);
        return true;
    }

    std::string_view m_text;
    const ImportWatch& m_watch;
    std::size_t m_at = 0;
    std::uint64_t m_line = 0;
};

enum class DxfValue { Words, Double, Int16, Int32, Int64, Byte, Chunk };

struct DxfCodes {
    int first, last;
    DxfValue value;
};

/// What is none of these is words.
constexpr std::array<DxfCodes, 19> binaryCodes{{
    {10, 59, DxfValue::Double},    {60, 79, DxfValue::Int16},      {90, 99, DxfValue::Int32},
    {110, 149, DxfValue::Double},  {160, 169, DxfValue::Int64},    {170, 179, DxfValue::Int16},
    {210, 239, DxfValue::Double},  {270, 289, DxfValue::Int16},    {290, 299, DxfValue::Byte},
    {310, 319, DxfValue::Chunk},   {370, 389, DxfValue::Int16},    {400, 409, DxfValue::Int16},
    {420, 429, DxfValue::Int32},   {440, 459, DxfValue::Int32},    {460, 469, DxfValue::Double},
    {1004, 1004, DxfValue::Chunk}, {1010, 1059, DxfValue::Double}, {1060, 1070, DxfValue::Int16},
    {1071, 1071, DxfValue::Int32},
}};

DxfValue valueOf(int code)
{
    for (const DxfCodes& codes : binaryCodes)
        if (code >= codes.first && code <= codes.last)
            return codes.value;
    return DxfValue::Words;
}

class BinaryGroups : public DxfGroups {
public:
    BinaryGroups(std::string_view bytes, const ImportWatch& watch)
        : m_bytes(bytes)
        , m_watch(watch)
        , m_at(binarySentinel.size())
    {
        // The first group is 0, SECTION. Up to R12 codes have one byte, and 255 says that two more follow.
        const std::string_view first = m_bytes.substr(m_at, 2);
        m_shortCodes = first.size() == 2 && (first[0] == '\xFF' || (first[0] == 0 && first[1] != 0));
    }

    bool next(DxfGroup& group) override
    {
        if (m_at >= m_bytes.size())
            return false;
        m_start = m_at;
        group.code = code();
        group.words = {};
        group.number.reset();
        switch (valueOf(group.code)) {
        case DxfValue::Words:
            group.words = trimmed(words());
            break;
        case DxfValue::Double:
            group.number = take<double>();
            break;
        case DxfValue::Int16:
            group.number = take<std::int16_t>();
            break;
        case DxfValue::Int32:
            group.number = take<std::int32_t>();
            break;
        case DxfValue::Int64:
            group.number = static_cast<double>(take<std::int64_t>());
            break;
        case DxfValue::Byte:
            group.number = take<std::uint8_t>();
            break;
        case DxfValue::Chunk:
            skip(take<std::uint8_t>());
            break;
        }
        count(m_watch, static_cast<double>(m_at) / static_cast<double>(m_bytes.size()));
        return true;
    }

    FilePlace place() const override { return {FilePlace::Unit::Byte, m_start}; }

private:
    void need(std::size_t bytes) const
    {
        if (m_bytes.size() - m_at < bytes)
            refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: the file ends in the middle of something"));
    }

    void skip(std::size_t bytes)
    {
        need(bytes);
        m_at += bytes;
    }

    /// Little endian, as all that Bolster runs on is.
    template <class T>
    T take()
    {
        need(sizeof(T));
        T value;
        std::memcpy(&value, m_bytes.data() + m_at, sizeof(T));
        m_at += sizeof(T);
        return value;
    }

    int code()
    {
        if (!m_shortCodes)
            return take<std::int16_t>();
        const int code = take<std::uint8_t>();
        return code == 255 ? take<std::int16_t>() : code;
    }

    std::string_view words()
    {
        const std::size_t end = m_bytes.find('\0', m_at);
        if (end == std::string_view::npos)
            need(m_bytes.size());
        const std::string_view found = m_bytes.substr(m_at, end - m_at);
        m_at = end + 1;
        return found;
    }

    std::string_view m_bytes;
    const ImportWatch& m_watch;
    std::size_t m_at;
    std::size_t m_start = 0;
    bool m_shortCodes = false;
};

} // namespace

void DxfGroups::count(const ImportWatch& watch, double done)
{
    if (++m_groups > mostGroups)
        refuseFile(place(),
                   QT_TRANSLATE_NOOP("Message", "%1: more is drawn in it than a pattern can have (over %2 groups)"),
                   {std::to_string(mostGroups)});
    if (m_groups % 65536 == 0)
        watch.check(0.3 + 0.7 * done);
}

std::unique_ptr<DxfGroups> dxfGroups(std::string_view file, const ImportWatch& watch)
{
    if (file.starts_with(binarySentinel))
        return std::make_unique<BinaryGroups>(file, watch);
    return std::make_unique<TextGroups>(file, watch);
}

double numberOf(const DxfGroup& group, const FilePlace& place)
{
    double value = group.number.value_or(0);
    std::string_view word = group.words;
    if (!group.number) {
        if (word.starts_with('+'))
            word.remove_prefix(1);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size())
            value = std::numeric_limits<double>::quiet_NaN();
    }
    if (!std::isfinite(value))
        refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a number"),
                   {group.number ? "nan" : excerpt(group.words)});
    if (std::abs(value) > largestDxfNumber)
        refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: %2 is larger than any pattern (%3)"),
                   {numberText(value), numberText(largestDxfNumber)});
    return value;
}

} // namespace bolster
