// Words and numbers of a text, line by line, as OBJ, OFF, and the text forms of PLY and STL have them.
#pragma once

#include "FileBytes.h"

namespace bolster {

/// Comments (a word that begins with '#') end a line; LF, CRLF and CR end it too. A backslash at the end of a line
/// joins it to the next one while words are read. Independent of the locale. Words are views that end with their
/// line.
class TextScanner {
public:
    explicit TextScanner(FileBytes text);

    /// Moves to the next line that holds something. False at the end.
    bool nextLine();
    /// The next word of this line, or "" at its end.
    std::string_view word();
    /// The next word of this or a later line, or "" at the end of the text.
    std::string_view wordOnAnyLine();
    /// Whether this line has another word.
    bool moreOnLine();
    /// What is left of this line, without blanks around it.
    std::string_view restOfLine();

    /// Numbers refuse when the word is missing or is not a number of that sort.
    double number() { return number(word()); }
    double number(std::string_view word) const;
    std::int64_t integer() { return integer(word()); }
    std::int64_t integer(std::string_view word) const;
    /// A number of things: an integer that is not negative.
    std::uint64_t count() { return count(word()); }
    std::uint64_t count(std::string_view word) const;

    /// The line; before the first one the file as a whole.
    FilePlace place() const { return {m_line > 0 ? FilePlace::Unit::Line : FilePlace::Unit::File, m_line}; }
    std::uint64_t bytesLeft() const { return m_window.size() - offset(); }
    /// Leaves this line; the byte that follows it.
    std::uint64_t offsetOfNextLine();

private:
    bool atLineEnd() const { return m_at == m_end || *m_at == '\n' || *m_at == '\r'; }
    /// The length of a backslash with the line end behind it, or 0.
    std::ptrdiff_t continuation() const;
    void skipBlanks();
    void leaveLine();
    /// Reads the next lines; false when there are none.
    bool fetchLines();
    std::uint64_t offset() const { return m_start + static_cast<std::uint64_t>(m_at - m_begin); }

    FileWindow m_window;
    std::uint64_t m_start = 0; // of the lines that are there
    const char* m_begin = nullptr;
    const char* m_at = nullptr;
    const char* m_end = nullptr;
    std::uint64_t m_line = 0;
};

} // namespace bolster
