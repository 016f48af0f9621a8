#include "CustomerPage.h"

#include "GlbFile.h"
#include "PackedFile.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace bolster {

namespace {

std::string asHtml(const std::string& text)
{
    std::string result;
    for (const char c : text)
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    return result;
}

/// In a script nothing may look as if it ended there.
std::string asScriptData(std::string json)
{
    for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6)
        json.replace(at, 1, "\\u003c");
    return json;
}

std::string factsJson(const PageFacts& facts)
{
    using Json = nlohmann::ordered_json;
    Json json{{"size", {facts.size.x(), facts.size.y(), facts.size.z()}},
              {"colors", facts.colors},
              {"seams", Json::array()}};
    for (const PageSeam& seam : facts.seams) {
        Json line = Json::array();
        for (const Eigen::Vector3f& p : seam.line)
            for (const float coordinate : yUp(p))
                line.push_back(std::lround(10 * coordinate) / 10.0);
        json["seams"].push_back({{"name", seam.name}, {"length", std::lround(seam.length)}, {"line", line}});
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Puts in what the names in {{}} stand for; what was put in is not looked at again.
std::string filledPage(const std::string& html, const std::map<std::string, std::string>& values)
{
    std::string page;
    std::size_t from = 0;
    for (std::size_t open = 0; (open = html.find("{{", from)) != std::string::npos;) {
        const std::size_t close = html.find("}}", open);
        if (close == std::string::npos)
            break;
        page.append(html, from, open - from);
        if (const auto value = values.find(html.substr(open + 2, close - open - 2)); value != values.end())
            page += value->second;
        from = close + 2;
    }
    return page + html.substr(from);
}

} // namespace

std::string base64(std::string_view bytes)
{
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i)
            three = three << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            text += at + i > bytes.size() ? '=' : letters[three >> (18 - 6 * i) & 63U];
    }
    return text;
}

std::string customerPage(const PageParts& parts, const CoverModel& model, const PageFacts& facts)
{
    std::string libraries;
    for (const std::string& library : parts.libraries)
        libraries += "<script>\n" + library + "\n</script>\n";
    return filledPage(parts.html, {{"title", asHtml(facts.title)},
                                   {"licence", parts.licence},
                                   {"style", parts.style},
                                   {"script", parts.script},
                                   {"libraries", libraries},
                                   {"facts", asScriptData(factsJson(facts))},
                                   {"model", base64(zlibPacked(glbFile(model, true)))}});
}

} // namespace bolster
