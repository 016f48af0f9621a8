// Lines drawn on a form, cut into its triangles. Private to the library.
#pragma once

#include "Form.h"

#include <set>
#include <utility>

namespace bolster {

/// Triangles with edges along lines.
struct TriangleSoup {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> part;              ///< of each triangle
    std::set<std::pair<int, int>> cuts; ///< edges along lines, the lesser point first
    std::set<int> ends = {};            ///< points inside where cuts end that no line has made
};

struct LinedTriangles : TriangleSoup {
    std::vector<Message> notes; ///< lines that end where nothing is
    std::vector<OpenEnd> openEnds;
    Message problem; ///< why no lines can be cut; the rest is empty then
};

/// What a draft before was of, so that lines that stay where they are need not be cut again.
struct FormDraft {
    TriangleSoup uncut, cut;         ///< the form, and with those lines in it
    std::vector<FormLine> cutLines;  ///< of `cut`
    std::vector<Message> notes;      ///< of them
    std::vector<FormLine> lastLines; ///< of the draft before
};

/// The form's triangles are oriented alike, and each place is one point; what is cut already stays so. A line that
/// ends a little before a border or another line goes on to there. Source: CGAL's corefinement of the form with a
/// ribbon across it along each line. With a draft lines follow the form less closely, and those that did not move
/// are as they were cut before.
/// What runs along where `cuts` cut the form anyway cuts nothing.
LinedTriangles cutAlong(const TriangleSoup& form, const FormCuts& cuts, const std::stop_token& stop,
                        FormDraft* draft = nullptr);

/// "(12.5, -40, 300)", of a place in mm.
std::string placeText(const Vec3& at);

} // namespace bolster
