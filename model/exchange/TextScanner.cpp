#include "TextScanner.h"

#include <algorithm>
#include <charconv>

namespace bolster {
namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

template <class Number>
bool parse(std::string_view word, Number& value)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

} // namespace

std::string excerpt(std::string_view word)
{
    constexpr std::size_t longest = 40;
    std::string result(word.substr(0, longest));
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return word.size() > longest ? result + "..." : result;
}

TextScanner::TextScanner(std::string_view text)
    : m_begin(text.data())
    , m_at(text.data())
    , m_end(text.data() + text.size())
{
    if (text.starts_with("\xEF\xBB\xBF")) // a byte order mark
        m_at += 3;
}

bool TextScanner::nextLine()
{
    while (true) {
        if (m_line > 0)
            leaveLine();
        if (m_at == m_end)
            return false;
        ++m_line;
        while (m_at != m_end && isBlank(*m_at))
            ++m_at;
        if (!atLineEnd() && *m_at != '#')
            return true;
    }
}

std::string_view TextScanner::word()
{
    skipBlanks();
    const char* const start = m_at;
    if (!atLineEnd() && *start == '#')
        return {};
    while (!atLineEnd() && !isBlank(*m_at) && !(*m_at == '\\' && continuation() > 0))
        ++m_at;
    return {start, static_cast<std::size_t>(m_at - start)};
}

std::string_view TextScanner::wordOnAnyLine()
{
    std::string_view found = m_line > 0 ? word() : std::string_view();
    while (found.empty() && nextLine())
        found = word();
    return found;
}

std::string_view TextScanner::restOfLine()
{
    while (m_at != m_end && isBlank(*m_at))
        ++m_at;
    const char* const start = m_at;
    while (!atLineEnd())
        ++m_at;
    const char* last = m_at;
    while (last != start && isBlank(last[-1]))
        --last;
    return {start, static_cast<std::size_t>(last - start)};
}

double TextScanner::number(std::string_view word) const
{
    double value = 0;
    if (word.empty())
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: a number is missing"));
    if (!parse(word, value))
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a number"), {excerpt(word)});
    return value;
}

std::int64_t TextScanner::integer(std::string_view word) const
{
    std::int64_t value = 0;
    if (word.empty())
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: a number is missing"));
    if (!parse(word, value))
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a whole number"), {excerpt(word)});
    return value;
}

std::uint64_t TextScanner::count(std::string_view word) const
{
    const std::int64_t value = integer(word);
    if (value < 0)
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: a count is negative"));
    return static_cast<std::uint64_t>(value);
}

std::uint64_t TextScanner::offsetOfNextLine()
{
    leaveLine();
    return static_cast<std::uint64_t>(m_at - m_begin);
}

std::ptrdiff_t TextScanner::continuation() const
{
    const std::ptrdiff_t left = m_end - m_at;
    if (left >= 2 && m_at[0] == '\\' && m_at[1] == '\n')
        return 2;
    return left >= 3 && m_at[0] == '\\' && m_at[1] == '\r' && m_at[2] == '\n' ? 3 : 0;
}

void TextScanner::skipBlanks()
{
    while (m_at != m_end) {
        if (isBlank(*m_at)) {
            ++m_at;
        } else if (const std::ptrdiff_t length = continuation(); length > 0) {
            m_at += length;
            ++m_line;
        } else {
            return;
        }
    }
}

void TextScanner::leaveLine()
{
    while (!atLineEnd())
        ++m_at;
    if (m_end - m_at >= 2 && m_at[0] == '\r' && m_at[1] == '\n')
        m_at += 2;
    else if (m_at != m_end)
        ++m_at;
}

} // namespace bolster
