// A named set of fabrics for patches. It changes what is seen, never the shape.
#pragma once

#include "ElementId.h"

#include <string>
#include <vector>

namespace bolster {

struct Colourway {
    struct Entry {
        ElementId patch{};
        ElementId fabric{};

        friend bool operator==(const Entry&, const Entry&) = default;
    };

    std::string name;
    std::vector<Entry> fabrics; ///< each patch at most once; the others show their own fabric
    std::string note = {};      ///< for people

    friend bool operator==(const Colourway&, const Colourway&) = default;
};

} // namespace bolster
