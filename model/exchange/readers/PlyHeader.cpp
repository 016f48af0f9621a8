#include "PlyHeader.h"

#include <algorithm>
#include <array>

namespace bolster {
namespace {

PlyType typeNamed(const TextScanner& text, std::string_view word)
{
    constexpr std::array<std::array<std::string_view, 2>, 8> names = {{{"char", "int8"},
                                                                       {"uchar", "uint8"},
                                                                       {"short", "int16"},
                                                                       {"ushort", "uint16"},
                                                                       {"int", "int32"},
                                                                       {"uint", "uint32"},
                                                                       {"float", "float32"},
                                                                       {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i][0] || word == names[i][1])
            return static_cast<PlyType>(i);
    refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a PLY number type"), {excerpt(word)});
}

PlyHeader::Format formatNamed(const TextScanner& text, std::string_view word)
{
    if (word == "ascii")
        return PlyHeader::Format::Text;
    if (word == "binary_little_endian")
        return PlyHeader::Format::LittleEndian;
    if (word == "binary_big_endian")
        return PlyHeader::Format::BigEndian;
    refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a PLY format"), {excerpt(word)});
}

PlyProperty readProperty(TextScanner& text)
{
    PlyProperty property;
    std::string_view word = text.word();
    if (word == "list") {
        word = text.word();
        property.countType = typeNamed(text, word);
        if (!isInteger(*property.countType))
            refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" cannot count a list"),
                       {excerpt(word)});
        word = text.word();
    }
    property.type = typeNamed(text, word);
    property.name = text.word();
    return property;
}

} // namespace

std::uint64_t byteSize(PlyType type)
{
    constexpr std::array<std::uint64_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

bool isInteger(PlyType type)
{
    return type != PlyType::Float32 && type != PlyType::Float64;
}

std::optional<std::size_t> PlyElement::find(std::string_view wanted, std::string_view otherName) const
{
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == wanted || (!otherName.empty() && properties[i].name == otherName))
            return i;
    return std::nullopt;
}

const PlyElement* PlyHeader::find(std::string_view name) const
{
    const auto found =
        std::find_if(elements.begin(), elements.end(), [&](const auto& e) { return e.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

PlyHeader readPlyHeader(TextScanner& text)
{
    if (!text.nextLine() || text.word() != "ply")
        refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file does not begin with \"ply\""));
    PlyHeader header;
    while (text.nextLine()) {
        const std::string_view keyword = text.word();
        if (keyword == "end_header") {
            return header;
        } else if (keyword == "format") {
            header.format = formatNamed(text, text.word());
        } else if (keyword == "element") {
            const std::string name(text.word());
            header.elements.push_back({name, text.count(), {}});
        } else if (keyword == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(readProperty(text));
        } else if (keyword != "comment" && keyword != "obj_info") {
            refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not expected in a PLY header"),
                       {excerpt(keyword)});
        }
    }
    refuseFile(text.place(), QT_TRANSLATE_NOOP("Message", "%1: the file ends too early"));
}

} // namespace bolster
