// What holds for all pieces of a pattern when it is cut.
#pragma once

#include "CutAllowance.h"
#include "NotchShape.h"

#include <optional>
#include <string>

namespace bolster {

struct DesignCutting {
    std::optional<CutAllowance> allowance = {}; ///< nothing: whoever exports it says, else CutAllowance{}
    AutomaticNotches notches = {};
    std::string style;   ///< name of the article; "": the design's
    std::string version; ///< for labels and files

    friend bool operator==(const DesignCutting&, const DesignCutting&) = default;
};

} // namespace bolster
