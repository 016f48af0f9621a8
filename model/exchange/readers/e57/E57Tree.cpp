#include "E57Tree.h"

#include <expat.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <memory>

namespace bolster {

namespace {

constexpr std::uint64_t largestTree = 64'000'000; // bytes
constexpr std::size_t mostNodes = 500'000;        // attributes count, too
constexpr std::size_t deepestNode = 40;
constexpr std::size_t bytesAtOnce = 32 * E57Pages::contentSize;

std::string_view trimmedXml(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

template <class Number>
std::optional<Number> xmlNumber(std::string_view text)
{
    text = trimmedXml(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// Nothing is thrown through the library's functions, which are in C.
class E57TreeParser {
public:
    E57TreeParser(E57Pages& pages, std::uint64_t start)
        : m_pages(pages)
        , m_start(start)
        , m_parser(XML_ParserCreate(nullptr), &XML_ParserFree)
    {
        if (!m_parser)
            throw std::bad_alloc();
        XML_SetUserData(m_parser.get(), this);
        XML_SetElementHandler(m_parser.get(), &E57TreeParser::begin, &E57TreeParser::end);
        XML_SetCharacterDataHandler(m_parser.get(), &E57TreeParser::text);
        XML_SetStartDoctypeDeclHandler(m_parser.get(), &E57TreeParser::documentType);
    }

    E57Node parse(std::uint64_t length)
    {
        for (std::uint64_t done = 0; done < length;) {
            m_pages.watch().checkStop();
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytesAtOnce, length - done));
            const std::string_view piece = m_pages.content(m_start + done, count);
            done += count;
            const XML_Status status =
                XML_Parse(m_parser.get(), piece.data(), static_cast<int>(count), done == length ? 1 : 0);
            if (m_thrown)
                std::rethrow_exception(m_thrown);
            if (status != XML_STATUS_OK)
                refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: this is not well-formed XML (%2)"),
                           {XML_ErrorString(XML_GetErrorCode(m_parser.get()))});
        }
        return std::move(m_root);
    }

private:
    FilePlace place() const
    {
        return m_pages.place(
            m_start + static_cast<std::uint64_t>(std::max<XML_Index>(0, XML_GetCurrentByteIndex(m_parser.get()))));
    }

    template <class Act>
    void guarded(const Act& act)
    {
        if (m_thrown)
            return;
        try {
            act();
        } catch (...) {
            m_thrown = std::current_exception();
            XML_StopParser(m_parser.get(), XML_FALSE);
        }
    }

    void open(const char* name, const char** attributes)
    {
        if (++m_count > mostNodes || m_open.size() > deepestNode)
            refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: more is described in it than a scan can have"));
        E57Node& node = m_open.empty() ? m_root : m_open.back()->children.emplace_back();
        node.name = name;
        for (; *attributes != nullptr; attributes += 2, ++m_count)
            node.attributes.emplace(attributes[0], attributes[1]);
        m_open.push_back(&node);
    }

    static void begin(void* self, const XML_Char* name, const XML_Char** attributes)
    {
        auto& parser = *static_cast<E57TreeParser*>(self);
        parser.guarded([&] { parser.open(name, attributes); });
    }
    static void end(void* self, const XML_Char*)
    {
        auto& parser = *static_cast<E57TreeParser*>(self);
        parser.guarded([&] { parser.m_open.pop_back(); });
    }
    static void text(void* self, const XML_Char* characters, int count)
    {
        auto& parser = *static_cast<E57TreeParser*>(self);
        parser.guarded([&] { parser.m_open.back()->text.append(characters, static_cast<std::size_t>(count)); });
    }
    static void documentType(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int)
    {
        auto& parser = *static_cast<E57TreeParser*>(self);
        parser.guarded([&] {
            refuseFile(parser.place(), QT_TRANSLATE_NOOP("Message", "%1: a document type is not expected here"));
        });
    }

    E57Pages& m_pages;
    std::uint64_t m_start;
    std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> m_parser;
    E57Node m_root;
    std::vector<E57Node*> m_open; // only the last child of each may grow, so they stay where they are
    std::size_t m_count = 0;
    std::exception_ptr m_thrown;
};

} // namespace

std::optional<double> e57Number(std::string_view text)
{
    return xmlNumber<double>(text);
}

std::optional<std::int64_t> e57Integer(std::string_view text)
{
    return xmlNumber<std::int64_t>(text);
}

const E57Node* E57Node::child(std::string_view called) const
{
    const auto found = std::ranges::find(children, called, &E57Node::name);
    return found == children.end() ? nullptr : &*found;
}

std::string_view E57Node::attribute(std::string_view called) const
{
    const auto found = attributes.find(called);
    return found == attributes.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<double> E57Node::number() const
{
    const std::optional<double> raw = trimmedXml(text).empty() ? 0 : e57Number(text);
    if (!raw || type() != "ScaledInteger")
        return raw;
    return *raw * e57Number(attribute("scale")).value_or(1) + e57Number(attribute("offset")).value_or(0);
}

std::optional<double> E57Node::number(std::string_view called) const
{
    const E57Node* const found = child(called);
    return found ? found->number() : std::nullopt;
}

E57Node readE57Tree(E57Pages& pages, std::uint64_t physical, std::uint64_t length)
{
    const std::uint64_t start = pages.logical(physical);
    pages.require(start, length);
    if (length > largestTree)
        refuseFile(pages.place(start),
                   QT_TRANSLATE_NOOP("Message", "%1: more is described in it than a scan can have"));
    return E57TreeParser(pages, start).parse(length);
}

} // namespace bolster
