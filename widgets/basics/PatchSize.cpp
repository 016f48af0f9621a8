#include "PatchSize.h"

#include "LayoutEdits.h"

namespace bolster {

Vec2 patchSize(const Patch& patch)
{
    return edits::layoutBox(patch).sizes();
}

} // namespace bolster
