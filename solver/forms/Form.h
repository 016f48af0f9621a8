// A form that shall be covered: where it is cut, and the pieces that it falls into.
#pragma once

#include "Design.h"
#include "Geometry.h"
#include "Message.h"
#include "TriangleMesh.h"

#include <array>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bolster {

/// A line drawn on a form.
struct FormLine {
    std::string name;
    std::vector<Vec3> points; ///< mm, on the form or near it
    bool closed = false;

    friend bool operator==(const FormLine&, const FormLine&) = default;
};

/// Where a form is cut.
struct FormCuts {
    bool groups = true;          ///< where two parts of the mesh meet
    std::optional<double> angle; ///< and where the form bends by more than that, degrees
    std::vector<FormLine> lines = {};
    /// And along edges of the mesh on these rows of points, mm: of CAD faces.
    std::vector<std::vector<Vec3>> edges = {};
    double onEdges = 0.05; ///< mm: how far from its row such an edge may lie; samples of CAD curves lie within 0.02
    bool divides = false;  ///< it will be divided: splinters, which lean anywhere, are mended as beside lines

    friend bool operator==(const FormCuts&, const FormCuts&) = default;
};

/// The other side of an edge that is cut; none at the form's border.
struct EdgeMate {
    int piece = -1;
    int edge = -1; ///< of its border

    bool none() const { return piece < 0; }
    friend bool operator==(const EdgeMate&, const EdgeMate&) = default;
};

/// Edges of a border, one behind the other, that are sewn to one row of another border (or of the same one), or lie
/// at the form's border.
struct BorderRow {
    std::size_t first = 0; ///< edge
    std::size_t count = 0;
    int matePiece = -1; ///< none: nothing is sewn to it
    int mateRow = -1;   ///< of that piece; its edges run the other way

    bool isSewn() const { return matePiece >= 0; }
};

/// A part of the form: one sheet with one border, which can be laid flat, if nothing is said against it.
struct FormPiece {
    std::string name;
    std::string part;        ///< of the form: its name
    std::vector<int> points; ///< of the form, by vertex; a point on a cut inside the piece has two vertices here
    std::vector<std::array<int, 3>> triangles; ///< vertices, counter-clockwise seen from outside
    std::vector<int>
        border; ///< vertices, once around, counter-clockwise; edge k goes from border[k] to the next one
    std::vector<EdgeMate> mates; ///< of each edge of the border
    std::vector<BorderRow> rows; ///< all of the border, from the first edge of a row on
    Message refusal;             ///< why no cloth lies flat like that: it is closed, has a handle or too many holes

    bool isSheet() const { return refusal.empty(); }

    std::size_t after(std::size_t edge) const { return edge + 1 < border.size() ? edge + 1 : 0; }
    std::size_t before(std::size_t edge) const { return edge > 0 ? edge - 1 : border.size() - 1; }
};

/// The end of a line inside a piece, which it cuts in like a dart and does not divide.
struct OpenEnd {
    std::string line;      ///< its name
    std::vector<Vec3> way; ///< mm, on the form: from there the nearest way to a border or another line; the end
                           ///< alone where there is neither
    Message note;          ///< what it means, among the notes of the form
};

struct Form {
    std::vector<Vec3> points; ///< mm, each place once
    std::vector<FormPiece> pieces;
    std::vector<OpenEnd> openEnds;
    std::vector<Message> notes;             ///< what was mended: faces turned round, rings cut open ...
    std::vector<Message> undivided;         ///< why pieces stay as they are that were to be divided
    Message problem;                        ///< why there is none; pieces are empty then
    std::vector<std::array<int, 2>> opened; ///< points at the ends of edges along which rings were cut open

    Box3 boundingBox() const; ///< mm
};

/// A form with more is made simpler first, with a note about how far that is off.
inline constexpr std::size_t mostFormTriangles = 300'000;

/// Edges inside a piece around which it bends by more than so many degrees, as pairs of vertices: its look.
std::vector<std::array<int, 2>> bentEdges(const Form& form, const FormPiece& piece, double degrees);

/// The fixation curves of a design, as lines.
std::vector<FormLine> linesOf(const Design& design);

struct FormDraft; // FormLines.h
/// Made with the first one, for cutForm.
std::shared_ptr<FormDraft> newFormDraft();

/// Cuts a mesh (mm). Points in the same place are one; triangles without area go; triangles are turned so that
/// neighbours agree, as most of each sheet have it. A ring is cut open along the shortest way between its borders.
/// What has no border, or handles as a cup has, is refused as a piece. When stopped there are no pieces and no
/// problem.
/// With a draft, while a line moves: nearly right, soon. Always the same one for the same form.
Form cutForm(const TriangleMesh& mesh, const FormCuts& cuts, const std::stop_token& stop = {},
             FormDraft* draft = nullptr);

} // namespace bolster
