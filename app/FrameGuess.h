// What a mesh from elsewhere probably means: files say neither unit nor axis.
#pragma once

#include "Frame.h"
#include "TriangleMesh.h"

#include <QString>

namespace bolster {

enum class UpAxis { Z, Y };
enum class FileUnit { Millimetre, Centimetre, Metre, Inch, Custom };

/// mm per unit; 0 for Custom.
double millimetresPer(FileUnit unit);
/// The unit with which the mesh has the size of a piece of furniture; Custom when there is none.
FileUnit guessUnit(const Box3& fileBox);
/// By the custom of the format.
UpAxis guessUpAxis(const QString& fileEnding);
/// Turns the file's axes to Bolster's: z up.
Quat rotationFor(UpAxis up);
/// Of the placed mesh, mm.
Box3 placedBox(const TriangleMesh& mesh, const Frame& frame);

} // namespace bolster
