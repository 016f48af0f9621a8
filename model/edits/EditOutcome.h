// What an operation has come to that can be refused, or that cannot keep everything.
#pragma once

#include "Design.h"

namespace bolster::edits {

struct Outcome {
    Edit edit;                      ///< empty when it is refused or would change nothing
    Message problem;                ///< why it is refused; empty else
    std::vector<ElementId> dropped; ///< what the edit removes because it makes no sense any more (ids before it)

    static Outcome refused(Message why) { return {{}, std::move(why), {}}; }
};

} // namespace bolster::edits
