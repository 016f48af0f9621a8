// The viewer of pages for customers, as it was compiled in.
#pragma once

#include "CustomerPage.h"

namespace bolster {

PageParts viewerParts();

} // namespace bolster
