#include "PolygonSplit.h"

#include <numeric>

namespace bolster {
namespace {

using Indices = std::vector<std::uint32_t>;

double cross(const Vec2& a, const Vec2& b, const Vec2& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The polygon in the plane of its mean normal, counter-clockwise; empty when it has no area.
std::vector<Vec2> flattened(std::span<const Vec3> corners)
{
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 2; i < corners.size(); ++i)
        normal += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    const double length = normal.norm();
    if (!(length > 0))
        return {};
    normal /= length;
    const Vec3 across = normal.unitOrthogonal();
    const Vec3 up = normal.cross(across);
    std::vector<Vec2> flat;
    flat.reserve(corners.size());
    for (const Vec3& corner : corners)
        flat.emplace_back((corner - corners[0]).dot(across), (corner - corners[0]).dot(up));
    return flat;
}

bool isConvex(const std::vector<Vec2>& flat)
{
    const std::size_t n = flat.size();
    for (std::size_t i = 0; i < n; ++i)
        if (cross(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0)
            return false;
    return true;
}

bool isEar(const std::vector<Vec2>& flat, const Indices& rest, std::size_t at)
{
    const std::size_t n = rest.size();
    const std::size_t before = (at + n - 1) % n;
    const std::size_t after = (at + 1) % n;
    const Vec2& a = flat[rest[before]];
    const Vec2& b = flat[rest[at]];
    const Vec2& c = flat[rest[after]];
    if (!(cross(a, b, c) > 0))
        return false;
    for (std::size_t i = 0; i < n; ++i) {
        if (i == before || i == at || i == after)
            continue;
        const Vec2& p = flat[rest[i]];
        if (p != a && p != c && cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0)
            return false;
    }
    return true;
}

/// Takes corners off until three are left, no ear is found, or the effort is used up.
void clipEars(const std::vector<Vec2>& flat, Indices& rest, std::vector<std::array<std::uint32_t, 3>>& triangles,
              std::int64_t& effort)
{
    std::size_t missed = 0;
    for (std::size_t at = 0; rest.size() > 3 && missed < rest.size() && effort > 0;) {
        const std::size_t n = rest.size();
        effort -= static_cast<std::int64_t>(n);
        if (isEar(flat, rest, at)) {
            triangles.push_back({rest[(at + n - 1) % n], rest[at], rest[(at + 1) % n]});
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at));
            missed = 0;
        } else {
            ++missed;
            ++at;
        }
        at %= rest.size();
    }
}

} // namespace

void splitPolygon(std::span<const Vec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles,
                  std::int64_t& effort)
{
    Indices rest(corners.size());
    std::iota(rest.begin(), rest.end(), 0u);
    if (corners.size() > 3 && effort > 0) {
        const std::vector<Vec2> flat = flattened(corners);
        if (!flat.empty() && !isConvex(flat))
            clipEars(flat, rest, triangles, effort);
    }
    for (std::size_t i = 2; i < rest.size(); ++i)
        triangles.push_back({rest[0], rest[i - 1], rest[i]});
}

} // namespace bolster
