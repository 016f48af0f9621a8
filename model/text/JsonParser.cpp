// Recursive descent over RFC 8259; the nesting limit bounds the recursion.
#include "JsonText.h"

#include "JsonCharacters.h"

#include <algorithm>

namespace bolster::json {

namespace {

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool isJsonDigit(char c)
{
    return c >= '0' && c <= '9';
}

} // namespace

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
        if (m_text.starts_with("\xFF\xFE") || m_text.starts_with("\xFE\xFF"))
            return fail(QT_TRANSLATE_NOOP("Message", "the text is UTF-16; save it as UTF-8"));
        skipSpace();
        if (ended())
            return fail(
                QT_TRANSLATE_NOOP("Message", "the file is empty; nothing was written to it, or it was lost"));
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
        if (c == '-' || isJsonDigit(c))
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
        while (!ended() && isJsonDigit(m_text[m_at]))
            ++m_at;
        return m_at > first;
    }

    bool number()
    {
        const std::size_t node = open(Kind::Number);
        accept('-');
        bool valid = accept('0') ? ended() || !isJsonDigit(m_text[m_at]) : digits();
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

} // namespace bolster::json
