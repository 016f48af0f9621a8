// Models as USDZ: what phones put into a room.
#pragma once

#include "CoverModel.h"

namespace bolster {

/// Metres, y up, standing on the floor around the origin, the front to +z. Colourways are a set of variants. The
/// same model gives the same bytes.
std::string usdzFile(const CoverModel& model);
/// What is in it beside the pictures.
std::string usdText(const CoverModel& model);

} // namespace bolster
