#include "CurveEdits.h"

namespace bolster::edits {} // namespace bolster::edits
