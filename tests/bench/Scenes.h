// What the benchmarks solve.
#pragma once

#include "CgalPeer.h"
#include "SewnMesh.h"
#include "SolveInput.h"

namespace bolster::bench {

/// A strip clamped at both ends, one of which has been moved along and turned with an arc of the strip's length: it
/// bends without buckling, so every method has one shape to go to. With so many vertices within 1 %; sizes in mm.
Design bentStrip(int vertices, double length, double width);
/// Where the unknowns lie in the pattern of a design of one patch.
Eigen::Matrix3Xd flatPlaces(const SewnMesh& mesh);
/// A design of one patch for those who know no patterns: flat, with the targets of the held vertices. Vertices are
/// numbered like the mesh's unknowns.
HeldSurface heldSurface(const SewnMesh& mesh);

/// A car seat of an insert between two bolsters with a panel on each side, held along its lower edges. With so many
/// vertices within 1 %, sewn ones counted once.
Design seat(int vertices, Continuity topSeams = Continuity::C0);
/// The seat over a box, padded all round (paper, section 4.1).
SolveInput cushionedSeat(int vertices, Continuity topSeams = Continuity::C0);
/// The seat with a scan of so many points all over it, 2 mm outside, a little noisy (section 4.2).
SolveInput scannedSeat(int vertices, int points);
/// The seat after the rear edge of its insert has been dragged until the insert was longer by this share.
Design withLongerInsert(const Design& seat, double share);

} // namespace bolster::bench
