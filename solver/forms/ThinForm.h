// Forms of very many triangles, with fewer.
#pragma once

#include "Geometry.h"
#include "Message.h"
#include "TriangleMesh.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace bolster {

struct ThinnedForm {
    TriangleMesh mesh;          ///< mm; a part for each of the form that is left
    std::vector<Message> notes; ///< how far it is off, and what was mended
};

/// With about `triangles`: short edges go first, so that those that stay are alike, and none turns its neighbours
/// over. Borders, edges between parts and those along `rows` (points, mm: of CAD faces) stay as they are, sharp
/// bends if enough of the others can go. Nothing when stopped; takes some ten seconds for a million triangles.
/// Source: edge collapse of CGAL.
std::optional<ThinnedForm> thinForm(const TriangleMesh& mesh, const std::vector<std::vector<Vec3>>& rows,
                                    std::size_t triangles, const std::stop_token& stop = {});

} // namespace bolster
