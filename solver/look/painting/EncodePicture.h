// Pictures as the bytes of files, and letters, by OpenImageIO.
#pragma once

#include "Imaging.h"

namespace bolster {

/// As Imaging::encode and Imaging::drawText promise.
std::string encodedPicture(const EncodeOrder& order, std::string& problem);
bool drawnText(const TextOrder& order, const char* font, float* share);

} // namespace bolster
