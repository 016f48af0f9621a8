// Edges of frames, along which covers may be fixed.
#pragma once

#include "BSpline.h"
#include "ImportWatch.h"
#include "Message.h"
#include "TriangleMesh.h"

#include <QString>

#include <string>

namespace bolster {

struct Assembly;

struct FrameEdge {
    std::vector<Vec3> points; ///< at least two; of a closed edge the first one is repeated at its end
    std::string part{};       ///< of the frame
    bool exact = false; ///< of a curve, within 0.02 mm; else of triangles, which know it no better than they are

    bool closed() const { return points.size() > 2 && points.front() == points.back(); }
};

struct ImportedEdges {
    std::vector<FrameEdge> edges; ///< file units; none when refused or stopped
    Message problem;              ///< why, with the file; empty when stopped
};

/// The edges of the faces in a CAD file (isCadEnding), each once. Takes as long as importAssembly; importMesh has
/// both of one reading.
ImportedEdges importFrameEdges(const QString& path, const ImportWatch& watch = {});

/// Of an assembly that was ordered with them.
std::vector<FrameEdge> edgesOf(const Assembly& assembly);

inline constexpr std::size_t mostBentTriangles = 3'000'000;

/// Of a mesh: where its triangles meet at more than 30 degrees, or end. Where more than two such lines meet, or one
/// turns by more than 40 degrees, edges begin and end. Nothing of more than mostBentTriangles triangles, or when
/// stopped.
std::vector<FrameEdge> bentEdges(const TriangleMesh& mesh, const std::stop_token& stop = {});

/// Each edge (mm) once: in IGES every face has its own.
std::vector<FrameEdge> distinctEdges(const std::vector<FrameEdge>& edges);

/// Edges (mm) of a part that go on in each other, within 10 degrees and 0.01 mm, as one: an outline with rounded
/// corners, for example. Where it could go on in several, it ends.
std::vector<FrameEdge> joinedSmoothly(const std::vector<FrameEdge>& edges);

/// A curve (mm) along an exact edge within 0.05 mm, along others within 0.25 mm of their points: a line, or a cubic
/// with few control points, with corners where it turns by more than 40 degrees. Nothing when all is in one place.
std::optional<BSpline3> curveOnEdge(const FrameEdge& edge);

} // namespace bolster
