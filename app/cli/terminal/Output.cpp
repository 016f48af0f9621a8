#include "Output.h"

#include "DirectWrite.h"
#include "Escaped.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bolster::cli {
namespace {

int resultsAreErrors = 0; // how often that is wanted

void print(std::FILE* stream, const std::string& text)
{
    const std::string line = escaped(text, Text::Line) + '\n';
    const DirectWrite direct;
    std::fwrite(line.data(), 1, line.size(), stream);
    std::fflush(stream);
}

} // namespace

void printResult(const std::string& line)
{
    print(resultsAreErrors ? stderr : stdout, line);
}

void sendResultsToErrors(bool send)
{
    resultsAreErrors += send ? 1 : -1;
}

void printError(const std::string& line)
{
    print(stderr, line);
}

void printProblems(const Problems& problems)
{
    for (const Problem& problem : problems)
        printError((problem.severity == Severity::Error ? "error: " : "warning: ") + problem.english());
}

std::string counted(std::int64_t count, const std::string& thing)
{
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string percentText(double share, int digits)
{
    constexpr double nothing = 1e-5;
    return numberText(std::abs(share) < nothing ? 0 : 100 * share, digits) + " %";
}

std::string countedProblems(const Problems& problems)
{
    const auto errors = std::count_if(problems.begin(), problems.end(),
                                      [](const Problem& problem) { return problem.severity == Severity::Error; });
    return counted(errors, "error") + ", " +
           counted(static_cast<std::int64_t>(problems.size()) - errors, "warning");
}

} // namespace bolster::cli
