// Pictures of force fields.
#pragma once

#include "FieldPicture.h"
#include "ForceField.h"

namespace bolster {

/// In the field's own axes: sections every 50 mm across x and z, arrows in the middle plane across x.
FieldPicture drawField(const ForceField& field);

} // namespace bolster
