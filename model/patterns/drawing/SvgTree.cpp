#include "SvgTree.h"

#include <QXmlStreamReader>

namespace bolster {

namespace {

constexpr std::uint64_t largestSvg = 50'000'000;
constexpr int mostElements = 500'000;
constexpr int deepestElement = 100;
constexpr int mostAttributes = 500; // Qt compares each with all others of its element

/// Counts quoted values between one "<" and its ">", without asking what is well-formed.
void refuseManyAttributes(std::string_view text, const ImportWatch& watch)
{
    const auto behind = [&](std::string_view end, std::size_t at) {
        const std::size_t found = text.find(end, at);
        return found == std::string_view::npos ? text.size() : found + end.size();
    };
    for (std::size_t at = 0; (at = text.find('<', at)) < text.size();) {
        watch.checkStop();
        const std::string_view rest = text.substr(at, 9);
        if (rest.starts_with("<!--") || rest.starts_with("<![CDATA[")) {
            at = behind(rest[2] == '-' ? "-->" : "]]>", at);
            continue;
        }
        int count = 0;
        for (++at; at < text.size() && text[at] != '>'; ++at)
            if (text[at] == '"' || text[at] == '\'') {
                at = std::min(text.find(text[at], at + 1), text.size());
                if (++count > mostAttributes)
                    refuseFile({FilePlace::Unit::Byte, at},
                               QT_TRANSLATE_NOOP("Message", "%1: an element has more than %2 attributes"),
                               {std::to_string(mostAttributes)});
            }
    }
}

class SvgParser {
public:
    explicit SvgParser(const FileBytes& bytes)
        : m_bytes(bytes)
    {
        if (bytes.size() > largestSvg)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: the file is larger than a pattern can be (%2 MB)"),
                       {std::to_string(largestSvg / 1'000'000)});
        m_reader.setEntityExpansionLimit(100);
        m_reader.setNamespaceProcessing(true);
    }

    SvgElement parse()
    {
        FileWindow window(m_bytes);
        const std::string_view all = window.view(0, m_bytes.size());
        refuseManyAttributes(all, m_bytes.watch());
        m_reader.addData(QByteArray(all.data(), static_cast<qsizetype>(all.size())));
        SvgElement root;
        if (m_reader.readNextStartElement())
            element(root, 0);
        if (m_reader.hasError())
            refuse();
        if (root.tag != "svg")
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 is not an SVG file"));
        return root;
    }

private:
    FilePlace place() const { return {FilePlace::Unit::Line, static_cast<std::uint64_t>(m_reader.lineNumber())}; }
    [[noreturn]] void refuse() const
    {
        refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: this is not well-formed XML (%2)"),
                   {m_reader.errorString().toStdString()});
    }

    static bool isText(const std::string& tag)
    {
        return tag == "text" || tag == "tspan" || tag == "title" || tag == "style";
    }

    void element(SvgElement& into, int depth)
    {
        if (++m_count > mostElements)
            refuseFile(
                place(),
                QT_TRANSLATE_NOOP("Message", "%1: more is drawn in it than a pattern can have (over %2 elements)"),
                {std::to_string(mostElements)});
        if (depth > deepestElement)
            refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: elements lie in each other more than %2 times"),
                       {std::to_string(deepestElement)});
        if (m_count % 1000 == 0)
            m_bytes.watch().check(static_cast<double>(m_reader.characterOffset()) /
                                  static_cast<double>(std::max<std::uint64_t>(1, m_bytes.size())));
        into.tag = m_reader.name().toString().toStdString();
        for (const QXmlStreamAttribute& attribute : m_reader.attributes()) {
            // Inkscape's names of layers, and links as they were before SVG 2.
            const std::string name = attribute.name().toString().toStdString();
            into.attributes.emplace(name, attribute.value().toString().toStdString());
        }
        while (!m_reader.atEnd()) {
            switch (m_reader.readNext()) {
            case QXmlStreamReader::StartElement: {
                SvgElement child;
                element(child, depth + 1);
                if (isText(into.tag))
                    into.words += child.words;
                into.children.push_back(std::move(child));
                break;
            }
            case QXmlStreamReader::Characters:
                if (isText(into.tag))
                    into.words += m_reader.text().toString().simplified().toStdString();
                break;
            case QXmlStreamReader::EndElement:
                return;
            default:
                break;
            }
        }
        refuse();
    }

    FileBytes m_bytes;
    QXmlStreamReader m_reader;
    int m_count = 0;
};

} // namespace

const std::string& SvgElement::attribute(std::string_view name) const
{
    static const std::string none;
    const auto found = attributes.find(name);
    return found == attributes.end() ? none : found->second;
}

SvgElement readSvgTree(const FileBytes& bytes)
{
    return SvgParser(bytes).parse();
}

} // namespace bolster
