#include "SvgStyles.h"

#include "DrawnWords.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace bolster {

namespace {

/// Without blanks of any kind around it.
std::string_view cssWord(std::string_view text)
{
    constexpr const char* blanks = " \t\r\n\f";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

void addProperty(SvgStyle& style, const std::string& key, const std::string& value)
{
    if (key == "display")
        style.displayed = value != "none";
    else if (key == "visibility" && value != "inherit")
        style.visible = value != "hidden" && value != "collapse";
    else if (key == "transform")
        style.transform = value;
    else if (key == "transform-origin")
        style.origin = value;
}

SvgStyle styleOf(std::string_view declarations)
{
    SvgStyle style;
    while (!declarations.empty()) {
        const std::size_t end = std::min(declarations.find(';'), declarations.size());
        const std::string_view one = declarations.substr(0, end);
        const std::size_t colon = one.find(':');
        if (colon != std::string_view::npos) {
            const std::string_view value = one.substr(colon + 1);
            addProperty(style, lowered(cssWord(one.substr(0, colon))),
                        lowered(cssWord(value.substr(0, value.find('!')))));
        }
        declarations.remove_prefix(std::min(end + 1, declarations.size()));
    }
    return style;
}

std::string withoutComments(std::string sheet)
{
    std::string result;
    for (std::size_t at = 0; at < sheet.size();) {
        const std::size_t begin = std::min(sheet.find("/*", at), sheet.size());
        result.append(sheet, at, begin - at);
        const std::size_t end = begin == sheet.size() ? begin : sheet.find("*/", begin + 2);
        at = end == std::string::npos ? sheet.size() : end + 2;
    }
    return result;
}

/// "rect", "*", ".hidden", "path.hidden", "#frame": no more than one class.
bool isSimple(std::string_view selector)
{
    int marks = 0;
    for (const char c : selector) {
        const bool mark = c == '.' || c == '#';
        marks += mark;
        if (!mark && c != '-' && c != '_' && !std::isalnum(static_cast<unsigned char>(c)) &&
            static_cast<unsigned char>(c) < 0x80 && selector != "*")
            return false;
    }
    return !selector.empty() && marks < 2;
}

std::vector<std::string> namesIn(std::string_view classes)
{
    std::vector<std::string> names;
    for (std::size_t at = 0; (at = classes.find_first_not_of(" \t\r\n", at)) != std::string_view::npos;) {
        const std::size_t end = std::min(classes.find_first_of(" \t\r\n", at), classes.size());
        names.emplace_back(classes.substr(at, end - at));
        at = end;
    }
    return names;
}

/// Where the block that begins at an opening brace ends: behind its closing one.
std::size_t blockEnd(std::string_view text, std::size_t open)
{
    int depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
        if (depth == 0)
            return at + 1;
    }
    return text.size();
}

} // namespace

void SvgStyle::take(const SvgStyle& other)
{
    if (other.displayed)
        displayed = other.displayed;
    if (other.visible)
        visible = other.visible;
    if (other.transform)
        transform = other.transform;
    if (other.origin)
        origin = other.origin;
}

SvgStyles::SvgStyles(const SvgElement& root)
{
    find(root);
}

void SvgStyles::find(const SvgElement& element)
{
    if (element.tag == "style")
        readSheet(withoutComments(element.words));
    for (const SvgElement& child : element.children)
        find(child);
}

void SvgStyles::readSheet(std::string sheet)
{
    std::string_view text = sheet;
    for (std::size_t open; (open = text.find('{')) != std::string_view::npos;) {
        std::string_view selectors = text.substr(0, open);
        // "@import ...;" has no block. Blocks in "@media" are for other media as likely as for this one.
        if (const std::size_t statement = selectors.rfind(';'); statement != std::string_view::npos)
            selectors.remove_prefix(statement + 1);
        selectors = cssWord(selectors);
        const std::size_t end = blockEnd(text, open);
        const std::string_view block = text.substr(open + 1, end - open - 2);
        if (selectors.starts_with('@')) {
            m_notUnderstood += block.find("display") != std::string_view::npos ||
                               block.find("visibility") != std::string_view::npos ||
                               block.find("transform") != std::string_view::npos;
        } else if (const SvgStyle style = styleOf(block); !style.empty()) {
            while (!selectors.empty()) {
                const std::size_t comma = std::min(selectors.find(','), selectors.size());
                addRule(cssWord(selectors.substr(0, comma)), style);
                selectors.remove_prefix(std::min(comma + 1, selectors.size()));
            }
        }
        text.remove_prefix(end);
    }
}

void SvgStyles::addRule(std::string_view selector, const SvgStyle& style)
{
    if (!isSimple(selector)) {
        ++m_notUnderstood;
        return;
    }
    Rule& rule = m_rules[std::string(selector)];
    rule.style.take(style);
    rule.order = ++m_order;
}

SvgStyle SvgStyles::of(const SvgElement& element) const
{
    SvgStyle style;
    for (const char* key : {"display", "visibility", "transform-origin"})
        if (const std::string& value = element.attribute(key); !value.empty())
            addProperty(style, key, lowered(cssWord(value)));
    if (!m_rules.empty()) {
        std::vector<std::string> names{"*", element.tag};
        for (const std::string& name : namesIn(element.attribute("class"))) {
            names.push_back(std::string(".").append(name));
            names.push_back(element.tag + "." + name);
        }
        if (const std::string& id = element.attribute("id"); !id.empty()) {
            names.push_back(std::string("#").append(id));
            names.push_back(element.tag + "#" + id);
        }
        // The more telling ones later, and of those that tell as much the later one.
        std::vector<std::pair<std::pair<int, int>, const SvgStyle*>> rules;
        for (const std::string& name : names)
            if (const auto found = m_rules.find(name); found != m_rules.end()) {
                const int weight = (name.find('#') != std::string::npos ? 4 : 0) +
                                   (name.find('.') != std::string::npos ? 2 : 0) +
                                   (std::isalpha(static_cast<unsigned char>(name[0])) ? 1 : 0);
                rules.push_back({{weight, found->second.order}, &found->second.style});
            }
        std::ranges::sort(rules);
        for (const auto& [weight, rule] : rules)
            style.take(*rule);
    }
    style.take(styleOf(element.attribute("style")));
    return style;
}

} // namespace bolster
