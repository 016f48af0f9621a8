// Work that several machines share: each does its part of it.
#pragma once

#include "Arguments.h"

namespace bolster::cli {

/// Every `of`th piece of the work, from the `which`th on.
struct JobShare {
    int which = 0, of = 1;
    bool has(int piece) const { return piece % of == which; }
};

/// Of `--part I/N`; all of it without one. Throws UsageError.
JobShare jobShare(const Arguments& arguments);

} // namespace bolster::cli
