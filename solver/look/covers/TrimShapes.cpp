#include "TrimShapes.h"

#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

using Vec3f = Eigen::Vector3f;

constexpr float bias = std::numbers::sqrt2_v<float> / 2; ///< piping is cut at 45 degrees: so it bends

/// A cross section: its middle, two directions across, and the radius along each.
struct Section {
    Vec3f middle, side, up;
    float radius = 1;
    float along = 0;            ///< mm from the beginning
    float girth = 1;            ///< the radius by which cloth lies around it
    Vec3f lean = Vec3f::Zero(); ///< added to the normals: where the radius changes
};

std::vector<Eigen::Vector2f> circle(int corners)
{
    std::vector<Eigen::Vector2f> points;
    for (int c = 0; c < corners; ++c) {
        const float angle =
            2 * std::numbers::pi_v<float> * (static_cast<float>(c) / static_cast<float>(corners) - 0.25F);
        points.emplace_back(std::cos(angle), std::sin(angle));
    }
    return points;
}

/// Skins sections. The pattern has a seam of its own, at the bottom: the first corner is there twice.
void skin(const std::vector<Section>& sections, int corners, TrimMesh& to)
{
    const auto round = circle(corners);
    const auto first = static_cast<std::uint32_t>(to.points.size());
    const auto row = static_cast<std::uint32_t>(corners + 1);
    for (const Section& section : sections)
        for (int c = 0; c <= corners; ++c) {
            const Eigen::Vector2f& at = round[static_cast<std::size_t>(c % corners)];
            const Vec3f out = at.x() * section.side + at.y() * section.up;
            to.points.push_back(section.middle + section.radius * out);
            to.normals.push_back((out + section.lean).normalized());
            const float around =
                2 * std::numbers::pi_v<float> * section.girth * static_cast<float>(c) / static_cast<float>(corners);
            to.cloth.emplace_back(bias * (section.along - around), bias * (section.along + around));
        }
    const auto count = static_cast<std::uint32_t>(sections.size());
    for (std::uint32_t s = 0; s + 1 < count; ++s)
        for (std::uint32_t c = 0; c < static_cast<std::uint32_t>(corners); ++c) {
            const std::uint32_t a = first + s * row + c, b = first + (s + 1) * row + c;
            to.triangles.push_back({a, a + 1, b});
            to.triangles.push_back({a + 1, b + 1, b});
        }
}

Vec3f across(const Vec3f& direction, const Vec3f& from)
{
    return (from - from.dot(direction) * direction).normalized();
}

/// Without points that would fold the pipe.
std::vector<CoverPoint3> thinned(const std::vector<CoverPoint3>& along, float least)
{
    std::vector<CoverPoint3> kept;
    for (const CoverPoint3& p : along)
        if (kept.empty() || (p.point - kept.back().point).norm() >= least)
            kept.push_back(p);
    return kept;
}

} // namespace

void addStitch(std::span<const CoverPoint3, stitchPoints> on, float width, TrimMesh& to)
{
    // Above the cover in units of the width, and the thickness there.
    constexpr std::array<float, stitchPoints> height{-0.35F, 0.22F, 0.36F, 0.22F, -0.35F};
    constexpr std::array<float, stitchPoints> thickness{0.55F, 0.95F, 1, 0.95F, 0.55F};
    constexpr int corners = 6;
    if (!((on.back().point - on.front().point).squaredNorm() > 0))
        return;
    std::vector<Section> sections;
    float along = 0;
    for (std::size_t i = 0; i < stitchPoints; ++i) {
        const Vec3f forward =
            (on[std::min<std::size_t>(i + 1, stitchPoints - 1)].point - on[i == 0 ? 0 : i - 1].point).normalized();
        const Vec3f up = across(forward, on[i].normal);
        if (i > 0)
            along += (on[i].point - on[i - 1].point).norm();
        sections.push_back({on[i].point + height[i] * width * on[i].normal, up.cross(forward), up,
                            0.5F * thickness[i] * width, along, 0.5F * width});
    }
    skin(sections, corners, to);
}

void addPipe(const std::vector<CoverPoint3>& along, bool closed, float radius, TrimMesh& to)
{
    constexpr int corners = 12;
    constexpr int capRings = 3;
    const std::vector<CoverPoint3> path = thinned(along, 0.25F * radius);
    const std::size_t count = path.size();
    if (count < (closed ? 3 : 2))
        return;
    std::vector<Section> sections;
    float length = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3f before = path[i > 0 ? i - 1 : closed ? count - 1 : 0].point;
        const Vec3f after = path[i + 1 < count ? i + 1 : closed ? 0 : count - 1].point;
        const Vec3f forward = (after - before).normalized(), up = across(forward, path[i].normal);
        if (i > 0)
            length += (path[i].point - before).norm();
        sections.push_back({path[i].point, up.cross(forward), up, radius, length, radius});
    }
    if (closed) {
        sections.push_back(sections.front()); // once more, where the cloth ends
        sections.back().along = length + (path.front().point - path.back().point).norm();
        skin(sections, corners, to);
        return;
    }
    // Half a ball; `side`: -1 before the pipe, 1 behind it. Cloth goes on over it: else it would lie along a line
    // there, and whoever asks for the direction of its threads gets none.
    const auto cap = [&](const Section& end, const Vec3f& outwards, int ring, float side) {
        const float angle = 0.5F * std::numbers::pi_v<float> * static_cast<float>(ring) / capRings;
        Section section = end;
        section.along += side * radius * angle;
        section.middle += radius * std::sin(angle) * outwards;
        section.radius = std::max(1e-3F, std::cos(angle)) * radius;
        section.lean = std::tan(std::min(angle, 1.5F)) * outwards;
        return section;
    };
    std::vector<Section> all;
    const Vec3f backward = (path.front().point - path[1].point).normalized();
    const Vec3f forward = (path.back().point - path[count - 2].point).normalized();
    for (int ring = capRings; ring > 0; --ring)
        all.push_back(cap(sections.front(), backward, ring, -1));
    all.insert(all.end(), sections.begin(), sections.end());
    for (int ring = 1; ring <= capRings; ++ring)
        all.push_back(cap(sections.back(), forward, ring, 1));
    skin(all, corners, to);
}

} // namespace bolster
