// What a file from elsewhere probably means: files say neither unit nor axis.
#pragma once

#include "Placement.h"

#include <QString>

#include <vector>

namespace bolster {

enum class UpAxis { Z, Y };
enum class FileUnit { Millimetre, Centimetre, Metre, Inch, Custom };

/// mm per unit; 0 for Custom.
double millimetresPer(FileUnit unit);
/// The unit with which the content has a size from a stool to `largest` mm; Custom when there is none.
FileUnit guessUnit(const Box3& fileBox, double largest);
inline constexpr double largestFurniture = 3500; ///< mm: a long sofa
inline constexpr double largestScan = 15000;     ///< mm: the room around it
/// By the custom of the format.
UpAxis guessUpAxis(const QString& fileEnding);
/// Turns the file's axes to Bolster's: z up.
Quat rotationFor(UpAxis up);
/// Of the placed points, mm.
Box3 placedBox(const std::vector<Vec3>& points, const Placement& placement);

} // namespace bolster
