#include "Arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>

namespace bolster::cli {
namespace {

template <class Number>
std::string textOf(Number value)
{
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// Refuses numbers with anything behind them, too, and NaN through the comparison.
template <class Number>
Number parsed(std::string_view option, const std::string& text, Number least, Number most)
{
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const std::string range = " (" + textOf(least) + " to " + textOf(most) + ")";
    if (error == std::errc::result_out_of_range && stop == end)
        throw UsageError(std::string(option) + " cannot be " + text + range);
    if (error != std::errc() || stop != end)
        throw UsageError(std::string(option) + " needs a " +
                         (std::is_integral_v<Number> ? "whole number" : "number") + ", not \"" + text + "\"");
    if (!(value >= least && value <= most))
        throw UsageError(std::string(option) + " cannot be " + text + range);
    return value;
}

} // namespace

QString exactText(const std::string& word)
{
    const QString text = QString::fromStdString(word);
    if (text.toStdString() != word)
        throw UsageError("the argument \"" + word +
                         "\" is not UTF-8, and names of files are; give the file another name (mv, convmv)");
    return text;
}

Arguments::Arguments(std::span<const std::string> words, std::span<const OptionRule> rules)
{
    std::ranges::for_each(words, exactText);
    bool optionsEnded = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (optionsEnded || word.size() < 2 || word[0] != '-') {
            m_positional.push_back(word);
            continue;
        }
        if (word == "--") {
            optionsEnded = true;
            continue;
        }
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const auto rule =
            std::find_if(rules.begin(), rules.end(), [&](const OptionRule& r) { return r.name == name; });
        if (rule == rules.end() || (!rule->takesValue && equals != std::string::npos))
            throw UsageError("unknown option \"" + word + "\"");
        std::string text;
        if (rule->takesValue && equals != std::string::npos)
            text = word.substr(equals + 1);
        else if (rule->takesValue && i + 1 < words.size())
            text = words[++i];
        if (rule->takesValue && text.empty())
            throw UsageError(name + " needs a value");
        if (m_options.contains(name) && !rule->mayRepeat)
            throw UsageError(name + " is given twice");
        m_options.emplace(name, text);
    }
}

QString Arguments::path(std::string_view option) const
{
    return QString::fromStdString(value(option).value_or(""));
}

std::vector<std::string> Arguments::values(std::string_view option) const
{
    std::vector<std::string> all;
    const auto [from, to] = m_options.equal_range(option);
    for (auto at = from; at != to; ++at)
        all.push_back(at->second);
    return all;
}

double Arguments::number(std::string_view option, double fallback, double least, double most) const
{
    const auto text = value(option);
    return text ? parsed(option, *text, least, most) : fallback;
}

int Arguments::integer(std::string_view option, int fallback, int least, int most) const
{
    const auto text = value(option);
    return text ? parsed(option, *text, least, most) : fallback;
}

QString Arguments::onlyFile(const std::string& what) const
{
    return files({what}).front();
}

std::vector<QString> Arguments::files(std::initializer_list<std::string> what) const
{
    if (m_positional.size() < what.size())
        throw UsageError(*(what.begin() + m_positional.size()) + " is missing");
    if (m_positional.size() > what.size())
        throw UsageError("unexpected argument \"" + m_positional[what.size()] + "\"");
    std::vector<QString> paths;
    for (const std::string& word : m_positional)
        paths.push_back(QString::fromStdString(word));
    return paths;
}

void Arguments::expectNoFile() const
{
    if (!m_positional.empty())
        throw UsageError("unexpected argument \"" + m_positional.front() + "\"");
}

std::optional<std::string> Arguments::value(std::string_view option) const
{
    const auto found = m_options.find(option);
    return found == m_options.end() ? std::nullopt : std::optional(found->second);
}

} // namespace bolster::cli
