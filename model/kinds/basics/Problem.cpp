#include "Problem.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace bolster {

std::string Problem::english() const
{
    std::string place = label;
    if (!field.empty())
        place += (place.empty() ? "" : ", ") + field;
    return place.empty() ? message.english() : place + ": " + message.english();
}

void addNew(Problems& problems, const Problems& more)
{
    const auto content = [](const Problem& p) {
        return std::tie(p.element, p.field, p.message.key, p.message.args, p.label, p.severity);
    };
    const auto less = [&](const Problem* a, const Problem* b) { return content(*a) < content(*b); };
    std::set<const Problem*, decltype(less)> known(less);
    for (const Problem& problem : problems)
        known.insert(&problem);
    Problems added;
    for (const Problem& problem : more)
        if (known.insert(&problem).second)
            added.push_back(problem);
    problems.insert(problems.end(), added.begin(), added.end());
}

bool hasErrors(const Problems& problems)
{
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& problem) { return problem.severity == Severity::Error; });
}

} // namespace bolster
