// The arguments of one subcommand.
#pragma once

#include <QString>

#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace bolster::cli {

/// The user called the program wrongly; what() says how, for a line on stderr.
class UsageError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A word of the command line; throws UsageError when it is not UTF-8: it would name another file.
QString exactText(const std::string& word);

struct OptionRule {
    std::string_view name; ///< with the dashes
    bool takesValue = false;
    bool mayRepeat = false;
};

/// `--name VALUE`, `--name=VALUE`, `--switch` in any order between positional arguments; "--" ends the options.
class Arguments {
public:
    /// Throws UsageError for unknown options, missing values, and options given twice that may not be.
    Arguments(std::span<const std::string> words, std::span<const OptionRule> rules);

    bool has(std::string_view option) const { return m_options.contains(option); }
    /// The path of an option, or "".
    QString path(std::string_view option) const;
    /// All values of an option that may be repeated.
    std::vector<std::string> values(std::string_view option) const;
    /// Numbers throw UsageError when they are none, or not within [least, most]. "." is the decimal point.
    double number(std::string_view option, double fallback, double least, double most) const;
    int integer(std::string_view option, int fallback, int least, int most) const;

    /// The only positional argument; throws UsageError when there is another number of them.
    QString onlyFile(const std::string& what) const;
    /// As many as there are names for them; throws UsageError when there is another number.
    std::vector<QString> files(std::initializer_list<std::string> what) const;
    std::size_t fileCount() const { return m_positional.size(); } ///< positional arguments
    /// Throws UsageError when there are positional arguments.
    void expectNoFile() const;

private:
    std::optional<std::string> value(std::string_view option) const;

    std::multimap<std::string, std::string, std::less<>> m_options;
    std::vector<std::string> m_positional;
};

} // namespace bolster::cli
