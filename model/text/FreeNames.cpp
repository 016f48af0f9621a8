#include "FreeNames.h"

namespace bolster {

namespace {

constexpr std::size_t mostDigits = 6; // what is longer is no count

} // namespace

std::string withoutNumber(const std::string& name)
{
    const std::size_t space = name.find_last_of(' ');
    if (space == std::string::npos || space == 0)
        return name;
    const std::size_t digits = name.size() - space - 1;
    const bool numbered =
        digits > 0 && digits <= mostDigits && name.find_first_not_of("0123456789", space + 1) == std::string::npos;
    return numbered ? name.substr(0, space) : name;
}

std::string FreeNames::free(const std::string& wanted)
{
    if (m_taken.insert(wanted).second)
        return wanted;
    const std::string stem = withoutNumber(wanted);
    for (int& count = m_next.try_emplace(stem, 2).first->second;; ++count)
        if (std::string name = stem + " " + std::to_string(count); m_taken.insert(name).second)
            return name;
}

} // namespace bolster
