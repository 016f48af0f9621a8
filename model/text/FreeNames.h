// Names that nobody has yet.
#pragma once

#include <map>
#include <set>
#include <string>

namespace bolster {

/// "Seat" of "Seat 2".
std::string withoutNumber(const std::string& name);

/// Each one given is taken from then on.
class FreeNames {
public:
    void take(const std::string& name) { m_taken.insert(name); }
    /// "Seat", or "Seat 2" ... when it is taken; "Seat 2" is followed by "Seat 3". However many are called alike,
    /// it does not begin to count anew.
    std::string free(const std::string& wanted);

private:
    std::set<std::string> m_taken;
    std::map<std::string, int> m_next; ///< by name without number: all before it are taken
};

} // namespace bolster
