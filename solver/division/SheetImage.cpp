#include "SheetImage.h"

#include "FormTree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

constexpr double alike = 0.1;    // mm
constexpr double asLarge = 0.01; // of the area

Box3 boxOf(const FormSheet& sheet)
{
    Box3 box;
    for (const Vec3& point : sheet.points)
        box.extend(point);
    return box;
}

bool liesOn(const FormSheet& sheet, const FormSheet& other, const std::stop_token& stop)
{
    std::vector<FormTree::Triangle> triangles;
    for (const auto& [a, b, c] : other.triangles)
        triangles.push_back({other.points[a], other.points[b], other.points[c]});
    const FormTree tree(std::move(triangles), stop);
    return std::ranges::all_of(sheet.points, [&](const Vec3& point) {
        return !stop.stop_requested() && (tree.nearestTo(point).at - point).norm() < alike;
    });
}

} // namespace

Vec3 SheetImage::of(const Vec3& at) const
{
    return (mirrored ? Vec3(-at.x(), at.y(), at.z()) : at) + shift;
}

FormSheet SheetImage::of(const FormSheet& sheet) const
{
    FormSheet image = sheet;
    for (Vec3& point : image.points)
        point = of(point);
    if (mirrored)
        for (auto& corners : image.triangles)
            std::swap(corners[1], corners[2]);
    return image;
}

std::optional<SheetImage> imageBetween(const FormSheet& sheet, const FormSheet& other, const std::stop_token& stop)
{
    const Box3 here = boxOf(sheet), there = boxOf(other);
    const double area = sheet.area();
    if (here.isEmpty() || !((here.sizes() - there.sizes()).norm() < alike) ||
        std::abs(area - other.area()) > asLarge * area)
        return std::nullopt;
    for (const bool mirrored : {true, false}) {
        SheetImage image{mirrored};
        image.shift = there.center() - image.of(here.center());
        const FormSheet moved = image.of(sheet);
        if (liesOn(moved, other, stop) && liesOn(other, moved, stop))
            return image;
    }
    return std::nullopt;
}

} // namespace bolster
