// A form's triangles with each place once. Private to the library.
#pragma once

#include "Message.h"
#include "TriangleMesh.h"

#include <array>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace bolster {

/// Each place once; triangles with an area, and the part that each belongs to.
struct WeldedForm {
    using Corners = std::array<int, 3>;

    std::vector<Vec3> points;
    std::vector<Corners> triangles;
    std::vector<int> part;
    std::vector<std::string> names;
    int twice = 0; ///< triangles that lay where another one does, and are left out
};

/// When stopped it means nothing.
WeldedForm weld(const TriangleMesh& mesh, const std::stop_token& stop = {});

/// Neighbours run along a common edge in opposite directions afterwards; each sheet as most of it does already, or,
/// if it is closed, with its outside outside.
void turnAlike(WeldedForm& form, std::vector<Message>& notes, const std::stop_token& stop);

/// Sheets that meet in a point, in an edge of three faces or with their wrong sides part there, so that each is a
/// surface that lines can be cut into.
void partSheets(WeldedForm& form, const std::stop_token& stop);

/// Edges whose ends follow each other `within` so many mm on one of these rows of points, the lesser end first.
std::set<std::pair<int, int>> edgesAlong(const WeldedForm& form, const std::vector<std::vector<Vec3>>& rows,
                                         double within);

} // namespace bolster
