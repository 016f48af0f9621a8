// What a file from elsewhere probably means: most say neither unit nor axis.
#pragma once

#include "Assembly.h"
#include "Placement.h"

#include <QString>

#include <optional>
#include <vector>

namespace bolster {

enum class FileUnit { Millimetre, Centimetre, Metre, Inch, Foot, Custom };

/// mm per unit; 0 for Custom.
double millimetresPer(FileUnit unit);
/// The unit with so many millimetres, or Custom.
FileUnit unitOf(double millimetresPerUnit);
/// The unit with which the content has a size from a stool to `largest` mm, or comes nearest to it; Custom when it
/// would be smaller or larger than anything that is meant (isPlausible) with all of them.
FileUnit guessUnit(const Box3& fileBox, double largest);
/// What the format itself says: scanners' formats are in metres. Nothing for the others.
std::optional<FileUnit> unitOf(const QString& fileEnding);
/// What an import proposes: what the file says of its unit, else what its kind says, else by its size.
FileUnit proposedUnit(const FileFacts& said, const QString& fileEnding, const Box3& fileBox, double largest);
/// What the file says, or its format; what they say nothing of is in millimetres, and z points up.
Placement saidPlacement(const FileFacts& said, const QString& fileEnding);
/// mm per unit for a content that has no known unit: the power of ten that makes it as large as furniture. 1 for
/// one without any size.
double guessFactor(const Box3& fileBox);
/// Whether something of this size can be seen and worked with: 1 mm to 100 m.
bool isPlausible(const Box3& placed);
inline constexpr double largestFurniture = 3500; ///< mm: a long sofa
inline constexpr double largestScan = 15000;     ///< mm: the room around it
/// By the custom of the format.
UpAxis guessUpAxis(const QString& fileEnding);
/// Of the placed points, mm.
Box3 placedBox(const std::vector<Vec3>& points, const Placement& placement);

} // namespace bolster
