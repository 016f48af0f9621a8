// The hash of a design, cheap to keep up with one that changes.
#pragma once

#include "Design.h"
#include "Hash.h"

namespace bolster {

/// The sum of the hashes of all elements, each of its number and its canonical text: a function of the design
/// alone. Following an edit costs what the edit changed.
class DesignHash {
public:
    DesignHash();

    Hash follow(const Design& design);

private:
    Design m_design;
    std::map<ElementId, Hash> m_elements;
    HashSum m_sum;
};

Hash hashOf(const Design& design);

} // namespace bolster
