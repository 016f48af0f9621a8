#include "TextScanner.h"

#include <algorithm>
#include <charconv>

namespace bolster {
namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

constexpr std::size_t longestLine = 16 << 20; // of a file that is not in memory as a whole

/// How many bytes there are up to the last end of a line that does not go on in the next one.
std::size_t completeLines(std::string_view text)
{
    for (std::size_t end = text.size(); end > 0; --end) {
        const std::string_view before = text.substr(0, end - 1);
        const bool lone = text[end - 1] == '\r' && end < text.size() && text[end] != '\n';
        if (lone || (text[end - 1] == '\n' && !before.ends_with('\\') && !before.ends_with("\\\r")))
            return end;
    }
    return 0;
}

template <class Number>
bool parse(std::string_view word, Number& value)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

bool hasDecimalComma(std::string_view word)
{
    const std::size_t comma = word.find(',');
    if (comma == std::string_view::npos)
        return false;
    std::string pointed(word);
    pointed[comma] = '.';
    double value = 0;
    return parse(pointed, value);
}

/// By its byte order mark.
bool isUtf16(std::string_view text)
{
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
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

TextScanner::TextScanner(FileBytes text)
    : m_window(std::move(text))
{
    fetchLines();
    if (std::string_view(m_begin, m_end).starts_with("\xEF\xBB\xBF")) // a byte order mark
        m_at += 3;
    else if (isUtf16({m_begin, m_end}))
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 is text in UTF-16, which is not read; save it as UTF-8"));
}

bool TextScanner::nextLine()
{
    while (true) {
        if (m_line > 0)
            leaveLine();
        if (m_at == m_end && !fetchLines())
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

bool TextScanner::moreOnLine()
{
    skipBlanks();
    return !atLineEnd() && *m_at != '#';
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
    if (parse(word, value))
        return value;
    if (hasDecimalComma(word))
        refuseFile(place(),
                   QT_TRANSLATE_NOOP("Message", "%1: \"%2\" has a decimal comma; export with decimal points"),
                   {excerpt(word)});
    refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a number"), {excerpt(word)});
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
    return offset();
}

bool TextScanner::fetchLines()
{
    m_start = offset();
    m_begin = m_at = m_end = nullptr;
    for (std::size_t least = 1; m_start < m_window.size();) {
        const std::string_view view = m_window.view(m_start, least);
        const bool all = m_start + view.size() == m_window.size();
        if (const std::size_t length = all ? view.size() : completeLines(view); length > 0) {
            m_begin = m_at = view.data();
            m_end = m_begin + length;
            return true;
        }
        if (view.size() >= longestLine)
            refuseFile({FilePlace::Unit::Line, m_line + 1},
                       QT_TRANSLATE_NOOP("Message", "%1: the line is too long"));
        least = 2 * view.size();
    }
    return false;
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
