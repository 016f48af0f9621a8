// Stretches of outlines, handle curves and fancy seams by their lengths.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Arc length (mm) between two control points of the element's curve in the pattern: between the places where they
/// have most influence, on a closed curve the shorter way. 0 when there are no such points.
double lengthBetween(const Design& design, ElementId id, int pointA, int pointB);

/// Gives that stretch another length (mm): its control points are scaled about its start, so that a straight edge
/// keeps its direction and a curve its shape. Empty when there is no such stretch, or no scale leads to the length.
Edit setLengthBetween(const Design& design, ElementId id, int pointA, int pointB, double length);

/// The control points on an edge of an outline from one corner to another one (stretch.from to stretch.to), both
/// included, in their order; all points when both are the same or the outline has no corners. Empty when there is
/// no such patch, or an end is no corner.
std::vector<int> pointsOfEdge(const Design& design, const Stretch& edge);
/// Arc length, mm; 0 when there is no such edge.
double edgeLength(const Design& design, const Stretch& edge);

/// Gives edges another length (mm): each keeps its direction, shape and, if its corners are free to move, its
/// middle. Edges beyond keep their shape, and darts there go along. `problem` says why nothing is done.
Edit setEdgeLengths(const Design& design, std::span<const Stretch> edges, double length,
                    Message* problem = nullptr);
/// Makes edges as long as the first one, which stays as it is, and what lies beside them keeps its shape: curves
/// that are deep enough bulge, of the others one end moves, and the edges beyond turn with it; a dart beside them
/// goes along as it is. Edges that share corners give way to each other.
Edit makeEdgesEqual(const Design& design, std::span<const Stretch> edges, Message* problem = nullptr);
/// Makes the second side of each seam as long as its first one, in the same way; the first one as long as the
/// second where only that ends at corners, with a note.
Edit makeSeamSidesEqual(const Design& design, std::span<const ElementId> seams, Message* problem = nullptr);

} // namespace bolster::edits
