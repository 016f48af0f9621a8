#include "ElementEdits.h"

namespace bolster::edits {} // namespace bolster::edits
