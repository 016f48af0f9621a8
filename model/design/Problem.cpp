#include "Problem.h"

#include <algorithm>

namespace bolster {

std::string Problem::english() const
{
    std::string place = label;
    if (!field.empty())
        place += (place.empty() ? "" : ", ") + field;
    return place.empty() ? message.english() : place + ": " + message.english();
}

bool hasErrors(const Problems& problems)
{
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& problem) { return problem.severity == Severity::Error; });
}

} // namespace bolster
