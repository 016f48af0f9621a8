// What the menu Insert makes, with everything guessed that can be guessed.
#pragma once

#include "DesignFile.h"
#include "Selection.h"
#include "SurfaceMesh.h"

namespace bolster {

/// A cushion around the selected frame, or the first one that has none, its voxels so large that they can be made.
/// Empty when there is no frame.
Edit insertCushion(const Design& design, const Selection::Elements& selected, const DesignFiles& files);
/// What to say of the voxels of a cushion that was inserted, when they are not the usual ones.
QString voxelNote(const Edit& inserted);
/// Foam for the selected cushion (or that of the selected foam or frame), or the first one; on top of the cover or
/// the frame. Empty when there is no cushion.
Edit insertFoam(const Design& design, const Selection::Elements& selected, Foam::Shape shape,
                const SurfaceMeshPtr& surface, const DesignFiles& files);

/// How thick the padding of a frame probably is, whole mm: the median distance of the fixation curves, which lie on
/// the cover. 30 where these lie on the frame itself, or far away.
double guessPadding(const Design& design, const Frame& frame, const TriangleMesh& mesh);

} // namespace bolster
