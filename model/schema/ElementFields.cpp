#include "ElementFields.h"

#include "DesignJson.h"
#include "ElementReader.h"

namespace bolster {
namespace {

ElementPtr quarantined(ElementId id, std::string text)
{
    Problems problems;
    Message wrong;
    if (const auto document = json::Document::parse(text, wrong)) {
        json::Report report(id, json::headingOf(document->root(), 0).label);
        json::readElement(document->root(), report);
        problems = report.problems();
    } else {
        problems.push_back({id, elementLabel("", id, ""), "", wrong});
    }
    if (problems.empty()) // readable alone: it was its number that could not be used
        problems.push_back({id,
                            elementLabel("", id, ""),
                            "id",
                            {QT_TRANSLATE_NOOP("Message", "another element had the same number; give this one a "
                                                          "number of its own")}});
    return makeElement(Quarantined{std::move(text), std::move(problems)});
}

std::string objectText(ElementId id, const ElementFields& fields)
{
    std::string text = id == settingsId ? "" : "\"id\": " + std::to_string(number(id));
    for (const auto& [key, value] : fields)
        text.append(text.empty() ? "" : ", ").append(json::quoted(key)).append(": ").append(value);
    return "{" + text + "}";
}

} // namespace

ElementFields elementFields(ElementId id, const ElementPtr& element)
{
    ElementFields fields;
    if (!element)
        return fields;
    if (const auto* bad = std::get_if<Quarantined>(element.get()))
        return {{"", bad->text}};
    const std::string text = writeElement(id, *element);
    Message wrong;
    if (const auto document = json::Document::parse(text, wrong))
        document->root().eachMember([&](const std::string& key, const json::Value& value) {
            if (key != "id")
                fields.emplace(key, value.source());
        });
    return fields;
}

ElementPtr elementFromFields(ElementId id, const ElementFields& fields)
{
    if (fields.empty())
        return nullptr;
    if (fields.size() == 1 && fields.begin()->first.empty())
        return id == settingsId ? nullptr : quarantined(id, fields.begin()->second);
    std::string text = objectText(id, fields);
    Message wrong;
    const auto document = json::Document::parse(text, wrong);
    json::Report report(id, {});
    if (id == settingsId) {
        if (!document)
            return nullptr;
        const Settings settings = json::readSettings(document->root(), report);
        return report.clean() ? makeElement(settings) : nullptr;
    }
    ElementPtr element = document ? json::readElement(document->root(), report) : nullptr;
    return element ? element : quarantined(id, std::move(text));
}

} // namespace bolster
