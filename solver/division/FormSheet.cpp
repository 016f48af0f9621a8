#include "FormSheet.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace bolster {

Vec3 FormSheet::areaNormal(std::size_t t) const
{
    const auto& [a, b, c] = triangles[t];
    return (points[b] - points[a]).cross(points[c] - points[a]) / 2;
}

Vec3 FormSheet::center(std::size_t t) const
{
    const auto& [a, b, c] = triangles[t];
    return (points[a] + points[b] + points[c]) / 3;
}

double FormSheet::area() const
{
    double area = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        area += areaNormal(t).norm();
    return area;
}

FormSheet sheetOf(const std::vector<Vec3>& points, const FormPiece& piece)
{
    FormSheet sheet;
    std::map<int, int> numbers;
    for (const std::array<int, 3>& corners : piece.triangles) {
        std::array<int, 3>& named = sheet.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const int point = piece.points[corners[k]];
            const auto [number, isNew] = numbers.emplace(point, static_cast<int>(sheet.points.size()));
            if (isNew)
                sheet.points.push_back(points[point]);
            named[k] = number->second;
        }
    }
    return sheet;
}

void append(TriangleMesh& mesh, const FormSheet& sheet, const std::string& part)
{
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.parts.push_back({part, static_cast<std::uint32_t>(mesh.triangles.size()),
                          static_cast<std::uint32_t>(sheet.triangles.size())});
    mesh.points.insert(mesh.points.end(), sheet.points.begin(), sheet.points.end());
    for (const auto& [a, b, c] : sheet.triangles)
        mesh.triangles.push_back({first + static_cast<std::uint32_t>(a), first + static_cast<std::uint32_t>(b),
                                  first + static_cast<std::uint32_t>(c)});
}

FormSheet together(FormSheet sheet, const FormSheet& other)
{
    const int first = static_cast<int>(sheet.points.size());
    sheet.points.insert(sheet.points.end(), other.points.begin(), other.points.end());
    for (const auto& [a, b, c] : other.triangles)
        sheet.triangles.push_back({first + a, first + b, first + c});
    return sheet;
}

std::vector<std::vector<Vec3>> slitsOf(const Form& form, std::size_t p)
{
    std::set<std::pair<int, int>> opened;
    for (const auto& [a, b] : form.opened)
        opened.insert(std::minmax(a, b));
    std::vector<std::vector<Vec3>> rows;
    const FormPiece& piece = form.pieces[p];
    for (std::size_t k = 0; k < piece.border.size(); ++k) {
        const int a = piece.points[piece.border[k]], b = piece.points[piece.border[piece.after(k)]];
        if (piece.mates[k].piece == static_cast<int>(p) && !opened.contains(std::minmax(a, b)))
            rows.push_back({form.points[a], form.points[b]});
    }
    return rows;
}

std::vector<std::vector<Vec3>> slitsOf(const Form& form)
{
    std::vector<std::vector<Vec3>> rows;
    for (std::size_t p = 0; p < form.pieces.size(); ++p)
        std::ranges::move(slitsOf(form, p), std::back_inserter(rows));
    return rows;
}

double borderOf(const Form& form)
{
    const FormPiece& piece = form.pieces.front();
    double length = 0;
    for (std::size_t k = 0; k < piece.border.size(); ++k)
        length +=
            (form.points[piece.points[piece.border[piece.after(k)]]] - form.points[piece.points[piece.border[k]]])
                .norm();
    return length;
}

double winding(const Form& form)
{
    const double length = borderOf(form);
    return length * length / (4 * std::numbers::pi * sheetOf(form.points, form.pieces.front()).area());
}

} // namespace bolster
