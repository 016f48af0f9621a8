// Parts of a form, while it is divided. Private to the library.
#pragma once

#include "Form.h"

#include <array>
#include <string>
#include <vector>

namespace bolster {

/// A part of a form that hangs together.
struct FormSheet {
    std::vector<Vec3> points; ///< mm
    std::vector<std::array<int, 3>> triangles;

    Vec3 areaNormal(std::size_t triangle) const; ///< mm^2
    Vec3 center(std::size_t triangle) const;
    double area() const; ///< mm^2
};

/// By points of the form: where it is only cut open it hangs together.
FormSheet sheetOf(const std::vector<Vec3>& points, const FormPiece& piece);

/// Adds triangles of a part to a mesh.
void append(TriangleMesh& mesh, const FormSheet& sheet, const std::string& part);

/// Both, with points of their own.
FormSheet together(FormSheet sheet, const FormSheet& other);

/// Edges where a piece is cut open, but for rings, for which another way may be shorter later.
std::vector<std::vector<Vec3>> slitsOf(const Form& form, std::size_t piece);
/// What is cut into pieces stays so.
std::vector<std::vector<Vec3>> slitsOf(const Form& form);

/// mm, of a form of one piece.
double borderOf(const Form& form);
/// Of a form of one piece: the square of its border's length over that of a disc of its size.
double winding(const Form& form);

} // namespace bolster
