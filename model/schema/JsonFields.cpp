#include "JsonFields.h"

#include <algorithm>
#include <cmath>

namespace bolster::json {

namespace {

constexpr std::size_t mostProblems = 100;

std::string joined(std::span<const char* const> words)
{
    std::string text;
    for (const char* word : words)
        text.append(text.empty() ? "" : ", ").append(quoted(word));
    return text;
}

bool flagIn(const Value& value, const std::string& field, Report& report)
{
    if (value.kind() != Kind::True && value.kind() != Kind::False)
        report.add(field, {QT_TRANSLATE_NOOP("Message", "must be true or false, without quotes")});
    return value.kind() == Kind::True;
}

std::string textIn(const Value& value, const std::string& field, Report& report)
{
    if (value.kind() != Kind::String)
        report.add(field, {QT_TRANSLATE_NOOP("Message", "must be a text in quotes")});
    return value.string();
}

} // namespace

Report::Report(ElementId element, std::string label)
    : m_element(element)
    , m_label(std::move(label))
{}

void Report::add(std::string field, Message message)
{
    if (m_problems.size() < mostProblems) {
        m_problems.push_back({m_element, m_label, std::move(field), std::move(message), Severity::Error});
        return;
    }
    if (m_problems.size() == mostProblems)
        m_problems.push_back({m_element, m_label, "", {}, Severity::Error});
    else
        ++m_unlisted;
    m_problems.back().message = {QT_TRANSLATE_NOOP("Message", "and %1 more problems of this element"),
                                 {std::to_string(m_unlisted + 1)}};
}

double numberIn(const Value& value, const std::string& field, Report& report, double limit)
{
    const std::optional<double> number = value.number();
    if (value.kind() != Kind::Number)
        report.add(field, {QT_TRANSLATE_NOOP("Message", "must be a number, without quotes")});
    else if (!number || std::abs(*number) > limit)
        report.add(field, {QT_TRANSLATE_NOOP("Message", "the number %1 is too large or too small; stay within %2"),
                           {std::string(value.source().substr(0, 40)), numberText(std::min(limit, 1e7))}});
    else
        return *number;
    return 0;
}

int integerIn(const Value& value, const std::string& field, Report& report, int low, int high)
{
    const std::optional<double> number = value.number();
    if (number && *number == std::floor(*number) && *number >= low && *number <= high)
        return static_cast<int>(*number);
    report.add(field, {QT_TRANSLATE_NOOP("Message", "must be a whole number from %1 to %2"),
                       {std::to_string(low), std::to_string(high)}});
    return low;
}

template <int Dim>
Eigen::Matrix<double, Dim, 1> vectorIn(const Value& value, const std::string& field, Report& report, double limit)
{
    Eigen::Matrix<double, Dim, 1> vector = Eigen::Matrix<double, Dim, 1>::Zero();
    if (!value.isArray() || value.size() != Dim) {
        report.add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of %1 numbers in square brackets"),
                           {std::to_string(Dim)}});
        return vector;
    }
    value.eachItem([&](std::size_t i, const Value& item) {
        vector[static_cast<Eigen::Index>(i)] = numberIn(item, field, report, limit);
    });
    return vector;
}

template Vec2 vectorIn<2>(const Value&, const std::string&, Report&, double);
template Vec3 vectorIn<3>(const Value&, const std::string&, Report&, double);
template Eigen::Vector4d vectorIn<4>(const Value&, const std::string&, Report&, double);

Fields::Fields(const Value& object, std::string path, Report& report)
    : m_path(std::move(path))
    , m_report(report)
{
    object.eachMember([&](std::string key, const Value& value) { m_members.push_back({std::move(key), value}); });
    std::stable_sort(m_members.begin(), m_members.end(),
                     [](const Member& a, const Member& b) { return a.key < b.key; });
    for (std::size_t i = 1; i < m_members.size(); ++i)
        if (m_members[i].key == m_members[i - 1].key)
            m_report.add(fieldOf(m_members[i].key),
                         {QT_TRANSLATE_NOOP("Message", "this key occurs twice; remove one of them")});
}

std::string Fields::fieldOf(std::string_view key) const
{
    return m_path + std::string(key);
}

bool Fields::has(std::string_view key) const
{
    return std::any_of(m_members.begin(), m_members.end(), [&](const Member& member) { return member.key == key; });
}

const Value* Fields::optional(std::string_view key)
{
    const Value* found = nullptr;
    for (Member& member : m_members) {
        if (member.key != key)
            continue;
        member.known = true;
        if (!found)
            found = &member.value;
    }
    return found;
}

const Value* Fields::required(std::string_view key)
{
    const Value* value = optional(key);
    if (!value)
        m_report.add(fieldOf(key), {QT_TRANSLATE_NOOP("Message", "this key is missing; add it")});
    return value;
}

double Fields::number(std::string_view key)
{
    const Value* value = required(key);
    return value ? numberIn(*value, fieldOf(key), m_report) : 0;
}

double Fields::number(std::string_view key, double fallback)
{
    return has(key) ? number(key) : fallback;
}

bool Fields::flag(std::string_view key)
{
    const Value* value = required(key);
    return value && flagIn(*value, fieldOf(key), m_report);
}

bool Fields::flag(std::string_view key, bool fallback)
{
    return has(key) ? flag(key) : fallback;
}

std::string Fields::text(std::string_view key)
{
    const Value* value = required(key);
    return value ? textIn(*value, fieldOf(key), m_report) : std::string();
}

std::string Fields::text(std::string_view key, const std::string& fallback)
{
    return has(key) ? text(key) : fallback;
}

ElementId Fields::id(std::string_view key)
{
    const Value* value = required(key);
    return value ? ElementId{integerIn(*value, fieldOf(key), m_report, 1, largestElementId)} : ElementId{};
}

template <int Dim>
Eigen::Matrix<double, Dim, 1> Fields::vector(std::string_view key, const Eigen::Matrix<double, Dim, 1>& fallback)
{
    const Value* value = optional(key);
    if (!value)
        return fallback;
    const std::size_t before = m_report.count();
    const auto vector = vectorIn<Dim>(*value, fieldOf(key), m_report);
    return m_report.count() == before ? vector : fallback;
}

template Vec2 Fields::vector<2>(std::string_view, const Vec2&);
template Vec3 Fields::vector<3>(std::string_view, const Vec3&);
template Eigen::Vector4d Fields::vector<4>(std::string_view, const Eigen::Vector4d&);

int Fields::choice(std::string_view key, std::span<const char* const> words)
{
    const Value* value = optional(key);
    if (!value)
        return 0;
    const std::string given = value->string();
    const auto found = std::find(words.begin(), words.end(), given);
    if (value->kind() == Kind::String && found != words.end())
        return static_cast<int>(found - words.begin());
    m_report.add(fieldOf(key), {QT_TRANSLATE_NOOP("Message", "must be one of %1"), {joined(words)}});
    return 0;
}

void Fields::finish()
{
    for (const Member& member : m_members)
        if (!member.known)
            m_report.add(fieldOf(member.key),
                         {QT_TRANSLATE_NOOP("Message", "this key is unknown; check its spelling or remove it")});
}

} // namespace bolster::json
