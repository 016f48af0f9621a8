// What a frame's mesh consists of, so that some of it can be left out: loose cushions that hide the frame itself.
#pragma once

#include "Frame.h"
#include "TriangleMesh.h"

#include <memory>
#include <optional>

namespace bolster {

/// A part (group) of the file; of a part that does not hang together, each piece that does. Points in the same
/// place hang together.
struct FramePiece {
    std::string name;       ///< "Seat", or "Seat#2" for the second largest of several pieces
    std::uint32_t part = 0; ///< of the mesh
    std::uint32_t triangleCount = 0;
    Box3 box; ///< file units
};

struct FramePieces {
    std::vector<FramePiece> pieces;        ///< part by part, the largest first
    std::vector<std::uint32_t> ofTriangle; ///< which piece each triangle of the mesh belongs to

    /// Of each piece, whether these names hide it: its own, or that of its part.
    std::vector<bool> hiddenBy(const TriangleMesh& mesh, const std::vector<std::string>& names) const;
    /// The names that hide just these pieces, and those that name nothing here and stay as they are.
    std::vector<std::string> namesFor(const TriangleMesh& mesh, const std::vector<bool>& hidden,
                                      const std::vector<std::string>& before) const;
    /// The piece that a triangle of shownMesh() belongs to; none when there is no such triangle.
    std::optional<int> ofShown(const TriangleMesh& mesh, const std::vector<bool>& hidden,
                               std::uint32_t triangle) const;
    /// Those of the names that name nothing.
    std::vector<std::string> unknown(const TriangleMesh& mesh, const std::vector<std::string>& names) const;
};

using FrameMeshPtr = std::shared_ptr<const TriangleMesh>;

/// At most 200 pieces of a part are told apart; what is left is one more.
FramePieces framePieces(const TriangleMesh& mesh);
/// The same, found once for each mesh. From any thread.
std::shared_ptr<const FramePieces> piecesOf(const FrameMeshPtr& mesh);

/// The mesh without what the frame hides; parts without triangles are left out. Made once: the same pointer for the
/// same mesh and names, and the mesh itself when nothing is hidden. Null for null. From any thread.
FrameMeshPtr shownMesh(const FrameMeshPtr& mesh, const std::vector<std::string>& hidden);

} // namespace bolster
