#include "JsonText.h"

#include <algorithm>
#include <charconv>

namespace bolster::json {

namespace {

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

// Length of the UTF-8 sequence at the start of the text, 0 if it is none (RFC 3629: no overlong forms, no
// surrogates).
std::size_t sequenceLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto continues = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
        return byte(i) >= low && byte(i) <= high;
    };
    const unsigned first = byte(0);
    if (first < 0x80)
        return 1;
    if (first >= 0xC2 && first <= 0xDF)
        return continues(1) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF)
        return continues(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF) && continues(2) ? 3 : 0;
    if (first >= 0xF0 && first <= 0xF4)
        return continues(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF) && continues(2) &&
                       continues(3)
                   ? 4
                   : 0;
    return 0;
}

void appendUtf8(std::string& text, unsigned code)
{
    const auto put = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | code >> 6);
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | code >> 18);
        put(0x80 | (code >> 12 & 0x3F));
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

// The four hexadecimal digits at the start of the text.
std::optional<unsigned> hexDigits(std::string_view text)
{
    unsigned code = 0;
    if (text.size() < 4)
        return std::nullopt;
    const auto result = std::from_chars(text.data(), text.data() + 4, code, 16);
    return result.ec == std::errc() && result.ptr == text.data() + 4 ? std::optional(code) : std::nullopt;
}

// The character of a \u escape, its two halves joined; `text` begins behind the u. Sets the digits that were used.
std::optional<unsigned> escapedCharacter(std::string_view text, std::size_t& used)
{
    const std::optional<unsigned> first = hexDigits(text);
    used = 4;
    if (!first || (*first >= 0xDC00 && *first <= 0xDFFF))
        return std::nullopt;
    if (*first < 0xD800 || *first > 0xDBFF)
        return first;
    used = 10;
    if (text.substr(4, 2) != "\\u")
        return std::nullopt;
    const std::optional<unsigned> second = hexDigits(text.substr(6));
    if (!second || *second < 0xDC00 || *second > 0xDFFF)
        return std::nullopt;
    return 0x10000 + ((*first - 0xD800) << 10) + (*second - 0xDC00);
}

} // namespace

/// Recursive descent; the nesting limit bounds the recursion.
class Parser {
public:
    Parser(std::string_view text, Document& document, Message& problem)
        : m_text(text)
        , m_nodes(document.m_nodes)
        , m_problem(problem)
    {}

    bool run()
    {
        if (m_text.starts_with("\xEF\xBB\xBF"))
            m_at = 3;
        if (!value(0))
            return false;
        skipSpace();
        return m_at == m_text.size() ||
               fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: the text goes on after the design's last "
                                                 "bracket; remove what follows"));
    }

private:
    bool fail(const char* key)
    {
        const std::string_view before = m_text.substr(0, m_at);
        const auto line = std::count(before.begin(), before.end(), '\n') + 1;
        const std::size_t start = before.rfind('\n') + 1; // 0 when there is none
        const auto characters = std::count_if(before.begin() + static_cast<std::ptrdiff_t>(start), before.end(),
                                              [](char c) { return (c & 0xC0) != 0x80; });
        m_problem = {key, {std::to_string(line), std::to_string(characters + 1)}};
        return false;
    }

    bool ended() const { return m_at >= m_text.size(); }
    bool sees(char c) const { return !ended() && m_text[m_at] == c; }
    bool accept(char c)
    {
        if (!sees(c))
            return false;
        ++m_at;
        return true;
    }
    void skipSpace()
    {
        while (!ended() && isSpace(m_text[m_at]))
            ++m_at;
    }

    std::size_t open(Kind kind)
    {
        m_nodes.push_back({static_cast<std::uint32_t>(m_at), 0, 0, kind});
        return m_nodes.size() - 1;
    }
    bool close(std::size_t node)
    {
        m_nodes[node].end = static_cast<std::uint32_t>(m_at);
        m_nodes[node].next = static_cast<std::uint32_t>(m_nodes.size());
        return true;
    }

    bool value(int depth)
    {
        skipSpace();
        if (ended())
            return fail(QT_TRANSLATE_NOOP("Message",
                                          "Line %1, column %2: the text ends in the middle of the design; "
                                          "the file is incomplete"));
        const char c = m_text[m_at];
        if (c == '{' || c == '[') {
            if (depth == deepestNesting)
                return fail(QT_TRANSLATE_NOOP("Message",
                                              "Line %1, column %2: brackets are nested more than 64 deep; "
                                              "no design needs that"));
            return c == '{' ? object(depth) : array(depth);
        }
        if (c == '"')
            return string();
        if (c == '-' || isDigit(c))
            return number();
        return word("null", Kind::Null) || word("false", Kind::False) || word("true", Kind::True) ||
               fail(QT_TRANSLATE_NOOP("Message",
                                      "Line %1, column %2: a value is expected here: a number, a text in "
                                      "quotes, true, false or a bracket (NaN and Infinity are no "
                                      "numbers)"));
    }

    bool word(std::string_view name, Kind kind)
    {
        if (m_text.substr(m_at, name.size()) != name)
            return false;
        const std::size_t node = open(kind);
        m_at += name.size();
        return close(node);
    }

    bool array(int depth)
    {
        const std::size_t node = open(Kind::Array);
        ++m_at;
        skipSpace();
        if (accept(']'))
            return close(node);
        do {
            if (!value(depth + 1))
                return false;
            skipSpace();
        } while (accept(','));
        return accept(']')
                   ? close(node)
                   : fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: a comma or \"]\" is missing here"));
    }

    bool object(int depth)
    {
        const std::size_t node = open(Kind::Object);
        ++m_at;
        skipSpace();
        if (accept('}'))
            return close(node);
        do {
            skipSpace();
            if (!sees('"'))
                return fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: a key in quotes is expected here"));
            if (!string())
                return false;
            skipSpace();
            if (!accept(':'))
                return fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: a colon is missing after the key"));
            if (!value(depth + 1))
                return false;
            skipSpace();
        } while (accept(','));
        return accept('}')
                   ? close(node)
                   : fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: a comma or \"}\" is missing here"));
    }

    bool string()
    {
        const std::size_t node = open(Kind::String);
        ++m_at;
        while (!ended() && !sees('"')) {
            if (static_cast<unsigned char>(m_text[m_at]) < 0x20)
                return fail(QT_TRANSLATE_NOOP("Message",
                                              "Line %1, column %2: a text in quotes must end on its line; "
                                              "a quote is missing"));
            if (sees('\\')) {
                if (!escape())
                    return fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: this is no valid escape; write a "
                                                             "backslash as \"\\\\\""));
                continue;
            }
            const std::size_t length = sequenceLength(m_text.substr(m_at));
            if (length == 0)
                return fail(QT_TRANSLATE_NOOP("Message",
                                              "Line %1, column %2: this is not UTF-8; save the file in that "
                                              "encoding"));
            m_at += length;
        }
        if (!accept('"'))
            return fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: the text ends inside quotes; the file is "
                                                     "incomplete"));
        return close(node);
    }

    bool escape()
    {
        const char c = m_at + 1 < m_text.size() ? m_text[m_at + 1] : '\0';
        std::size_t digits = 0;
        if (c == 'u' ? !escapedCharacter(m_text.substr(m_at + 2), digits)
                     : std::string_view("\"\\/bfnrt").find(c) == std::string_view::npos)
            return false;
        m_at += 2 + digits;
        return true;
    }

    bool digits()
    {
        const std::size_t first = m_at;
        while (!ended() && isDigit(m_text[m_at]))
            ++m_at;
        return m_at > first;
    }

    bool number()
    {
        const std::size_t node = open(Kind::Number);
        accept('-');
        bool valid = accept('0') ? ended() || !isDigit(m_text[m_at]) : digits();
        if (valid && accept('.'))
            valid = digits();
        if (valid && (accept('e') || accept('E'))) {
            if (!accept('+'))
                accept('-');
            valid = digits();
        }
        return valid
                   ? close(node)
                   : fail(QT_TRANSLATE_NOOP("Message", "Line %1, column %2: this is no number; write it like 12.5, "
                                                       "-3 or 1e-3"));
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::vector<Document::Node>& m_nodes;
    Message& m_problem;
};

std::optional<Document> Document::parse(std::string_view text, Message& problem)
{
    if (text.size() > largestText) {
        problem = {QT_TRANSLATE_NOOP("Message", "the text is larger than %1 MB; that is no design"),
                   {std::to_string(largestText >> 20)}};
        return std::nullopt;
    }
    Document document;
    document.m_text = text;
    if (!Parser(text, document, problem).run())
        return std::nullopt;
    return document;
}

Kind Value::kind() const
{
    return m_document->m_nodes[m_index].kind;
}

std::uint32_t Value::next(std::uint32_t index) const
{
    return m_document->m_nodes[index].next;
}

std::string_view Value::source() const
{
    const Document::Node& node = m_document->m_nodes[m_index];
    return m_document->m_text.substr(node.begin, node.end - node.begin);
}

std::optional<double> Value::number() const
{
    if (kind() != Kind::Number)
        return std::nullopt;
    const std::string_view text = source();
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc() ? std::optional(value) : std::nullopt;
}

std::string Value::string() const
{
    std::string text;
    if (kind() != Kind::String)
        return text;
    const std::string_view inside = source().substr(1, source().size() - 2);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (inside[i] != '\\') {
            text += inside[i];
            continue;
        }
        const char c = inside[++i];
        if (c == 'u') {
            std::size_t digits = 0;
            appendUtf8(text, *escapedCharacter(inside.substr(i + 1), digits));
            i += digits;
        } else {
            static constexpr std::string_view names = "bfnrt";
            const std::size_t found = names.find(c);
            text += found == std::string_view::npos ? c : "\b\f\n\r\t"[found];
        }
    }
    return text;
}

std::size_t Value::size() const
{
    std::size_t count = 0;
    eachItem([&](std::size_t, const Value&) { ++count; });
    return kind() == Kind::Object ? count / 2 : count;
}

std::string quoted(std::string_view text)
{
    std::string result = "\"";
    while (!text.empty()) {
        const char c = text.front();
        std::size_t length = sequenceLength(text);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            static constexpr std::string_view hex = "0123456789abcdef";
            result += "\\u00";
            result += hex[static_cast<std::size_t>(c) >> 4];
            result += hex[static_cast<std::size_t>(c) & 15];
        } else if (length == 0) {
            result += "\xEF\xBF\xBD"; // not UTF-8: the replacement character
            length = 1;
        } else {
            result += text.substr(0, length);
        }
        text.remove_prefix(length);
    }
    return result + '"';
}

} // namespace bolster::json
