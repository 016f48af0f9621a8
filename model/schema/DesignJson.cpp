#include "DesignJson.h"

#include "ElementReader.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr int formatVersion = 1;

Problem designProblem(std::string field, Message message)
{
    return {settingsId, "design", std::move(field), std::move(message), Severity::Error};
}

// Numbers the elements that have no valid number of their own: the first free one above that of the element before,
// and above one that an earlier element took. So they keep their places, and with them their numbers, through
// writing and reading.
class Numbering {
public:
    void take(ElementId id)
    {
        std::int32_t first = number(id);
        std::int32_t last = first;
        const auto after = m_runs.upper_bound(first);
        if (after != m_runs.end() && after->first == last + 1)
            last = after->second;
        if (after != m_runs.begin() && std::prev(after)->second >= first - 1)
            first = std::prev(after)->first;
        m_runs.erase(m_runs.lower_bound(first), m_runs.upper_bound(last));
        m_runs[first] = last;
    }

    ElementId takeFreshAfter(ElementId before)
    {
        const std::int32_t wanted = number(before) + 1; // may pass the largest one that a file may use
        const auto after = m_runs.upper_bound(wanted);
        const bool taken = after != m_runs.begin() && std::prev(after)->second >= wanted;
        const ElementId fresh{taken ? std::prev(after)->second + 1 : wanted};
        take(fresh);
        return fresh;
    }

private:
    std::map<std::int32_t, std::int32_t> m_runs; // first and last of each gapless run of numbers in use
};

std::string oneLine(std::string_view text)
{
    std::string line(text);
    for (char& c : line) // line breaks cannot occur inside quotes
        c = c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
    return line;
}

void readElements(const json::Value& list, ReadDesign& result)
{
    std::vector<json::Heading> headings;
    std::set<ElementId> met;
    Numbering numbering;
    list.eachItem([&](std::size_t i, const json::Value& item) {
        headings.push_back(json::headingOf(item, i));
        if (headings.back().id != noElement && met.insert(headings.back().id).second)
            numbering.take(headings.back().id);
    });

    met.clear();
    Edit edit;
    ElementId before{};
    list.eachItem([&](std::size_t i, const json::Value& item) {
        const json::Heading& heading = headings[i];
        const bool unique = heading.id != noElement && met.insert(heading.id).second;
        const ElementId id = unique ? heading.id : numbering.takeFreshAfter(std::max(before, heading.id));
        before = id;
        json::Report report(id, heading.label);
        ElementPtr element = json::readElement(item, report);
        if (!unique && heading.id != noElement)
            report.add("id",
                       {QT_TRANSLATE_NOOP("Message", "another element has the number %1 already; give this one "
                                                     "a number of its own"),
                        {std::to_string(number(heading.id))}});
        if (!report.clean()) {
            result.problems.insert(result.problems.end(), report.problems().begin(), report.problems().end());
            element = makeElement(Quarantined{oneLine(item.source()), report.problems()});
        }
        edit.changes.push_back({id, nullptr, std::move(element)});
    });
    result.design = result.design.with(edit);
}

// Nothing when the text is a design of this version, whatever may be wrong inside.
std::optional<Problem> headProblem(json::Fields& fields)
{
    const json::Value* format = fields.optional("format");
    if (!format || format->string() != "bolster-design")
        return designProblem("format",
                             {QT_TRANSLATE_NOOP("Message", "this is no Bolster design; it must say \"format\": "
                                                           "\"bolster-design\"")});
    const json::Value* version = fields.optional("version");
    const std::optional<double> number = version ? version->number() : std::nullopt;
    if (number && *number > formatVersion)
        return designProblem("version",
                             {QT_TRANSLATE_NOOP("Message", "the design was made by a newer Bolster (version "
                                                           "%1 of the format, this program knows %2); update "
                                                           "the program"),
                              {numberText(*number, 15), std::to_string(formatVersion)}});
    if (!number || *number != formatVersion)
        return designProblem("version",
                             {QT_TRANSLATE_NOOP("Message", "must be %1"), {std::to_string(formatVersion)}});
    // Taken for millimetres everything would have a wrong size: nothing that could be left out.
    if (const json::Value* unit = fields.optional("unit"); unit && unit->string() != "mm")
        return designProblem("unit",
                             {QT_TRANSLATE_NOOP("Message", "must be \"mm\"; convert the design to millimetres")});
    return std::nullopt;
}

} // namespace

ReadDesign readDesign(std::string_view text)
{
    ReadDesign result;
    Message wrong;
    const std::optional<json::Document> document = json::Document::parse(text, wrong);
    if (!document) {
        result.problems.push_back({settingsId, "", "", std::move(wrong), Severity::Error});
        return result;
    }
    json::Report report(settingsId, "design");
    json::Fields fields(document->root(), "", report);
    std::optional<Problem> problem = headProblem(fields);
    if (problem || !report.clean()) { // with a key twice, one of the two values would get lost
        result.problems = report.problems();
        if (problem)
            result.problems.push_back(std::move(*problem));
        return result;
    }

    const json::Value* settings = fields.optional("settings");
    const json::Value* elements = fields.required("elements");
    if (elements && !elements->isArray())
        report.add("elements", {QT_TRANSLATE_NOOP("Message", "must be a list of elements in square brackets")});
    if (elements && elements->isArray() && elements->size() > mostElements) {
        result.problems.push_back(designProblem("elements", {QT_TRANSLATE_NOOP("Message", "a design has at most %1 "
                                                                                          "elements"),
                                                             {std::to_string(mostElements)}}));
        return result;
    }
    fields.finish();
    result.readable = true;
    result.problems = report.problems();
    if (settings) {
        json::Report own(settingsId, "settings");
        const Settings value = json::readSettings(*settings, own);
        result.design = result.design.with({{}, {{settingsId, nullptr, makeElement(value)}}});
        result.problems.insert(result.problems.end(), own.problems().begin(), own.problems().end());
    }
    if (elements && elements->isArray())
        readElements(*elements, result);
    return result;
}

} // namespace bolster
