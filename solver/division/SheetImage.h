// Sheets that are alike: one of them shifted, or mirrored from left to right, is the other.
#pragma once

#include "Fiedler.h"

#include <optional>

namespace bolster {

/// Mirrored at x = 0 or not, then shifted (mm).
struct SheetImage {
    bool mirrored = false;
    Vec3 shift = Vec3::Zero();

    Vec3 of(const Vec3& at) const;
    FormSheet of(const FormSheet& sheet) const;
};

/// How a sheet becomes the other one, within a tenth of a millimetre; their triangles may be others. Nothing where
/// they are not alike, or when stopped.
std::optional<SheetImage> imageBetween(const FormSheet& sheet, const FormSheet& other, const std::stop_token& stop);

} // namespace bolster
