#include "PatchEdits.h"

namespace bolster::edits {} // namespace bolster::edits
