// JSON as it stands in a file: every value knows its place. Private to the library.
//
// A general JSON library would lose what the text form of a design promises: the exact text of an element that
// cannot be read, keys that occur twice, which number does not fit into a double, and a message with line and
// column that a designer understands.
#pragma once

#include "Message.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bolster::json {

enum class Kind : std::uint8_t { Null, False, True, Number, String, Array, Object };

/// Arrays and objects must not lie deeper in each other than this.
inline constexpr int deepestNesting = 64;
/// Bytes of a text.
inline constexpr std::size_t largestText = 16u << 20;

class Document;

/// One value of a document, valid as long as that.
class Value {
public:
    Kind kind() const;
    bool isObject() const { return kind() == Kind::Object; }
    bool isArray() const { return kind() == Kind::Array; }
    /// The text, from the first to the last character of the value.
    std::string_view source() const;
    /// Nothing when it is not a number or does not fit into a double.
    std::optional<double> number() const;
    /// The decoded text of a string, UTF-8.
    std::string string() const;
    /// Number of items of an array.
    std::size_t size() const;

    /// Calls visit(index, Value) for each item of an array; other values have none.
    template <class Visit>
    void eachItem(Visit visit) const
    {
        if (!isArray())
            return;
        std::size_t index = 0;
        for (std::uint32_t i = m_index + 1; i < next(m_index); i = next(i))
            visit(index++, Value(m_document, i));
    }
    /// Calls visit(key, Value) for each member of an object, in the order of the text; other values have none.
    template <class Visit>
    void eachMember(Visit visit) const
    {
        if (!isObject())
            return;
        for (std::uint32_t i = m_index + 1; i < next(m_index); i = next(i + 1))
            visit(Value(m_document, i).string(), Value(m_document, i + 1));
    }

private:
    friend class Document;
    Value(const Document* document, std::uint32_t index)
        : m_document(document)
        , m_index(index)
    {}
    std::uint32_t next(std::uint32_t index) const;

    const Document* m_document;
    std::uint32_t m_index;
};

/// A parsed text, which must live as long. A flat list of places: 16 bytes per value, whatever comes.
class Document {
public:
    /// Nothing when the text is not JSON; then `problem` names the line and column.
    static std::optional<Document> parse(std::string_view text, Message& problem);

    Value root() const { return Value(this, 0); }

private:
    friend class Value;
    friend class Parser;

    struct Node {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::uint32_t next = 0; ///< the node after this value and all inside it
        Kind kind = Kind::Null;
    };

    std::string_view m_text;
    std::vector<Node> m_nodes; // depth first; in an object key and value alternate
};

/// The shortest text that reads back as the same double. JSON has no others than finite ones: "null" for them.
std::string text(double value);

/// Text in quotes, with escapes only where JSON needs them.
std::string quoted(std::string_view text);

} // namespace bolster::json
