// Which edges of the borders of a form's pieces make one seam. Private to the library.
#pragma once

#include "Form.h"

namespace bolster {

/// Divides the borders of all pieces into rows; both sides of a seam alike. What runs all around in one is divided
/// into halves.
void findRows(Form& form);

} // namespace bolster
