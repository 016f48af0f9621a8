#include "CoverMap.h"

#include "FrameDistance.h"
#include "MeanCurvature.h"
#include "ScanMeasure.h"
#include "TriangleStrain.h"
#include "TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace bolster {

namespace {

using Kind = CoverMap::Kind;

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
constexpr double farthestFrame = 1000; // mm: more is no foam

constexpr std::array<std::pair<std::string_view, Kind>, 7> words = {{{"strain", Kind::Strain},
                                                                     {"along", Kind::Along},
                                                                     {"across", Kind::Across},
                                                                     {"shear", Kind::Shear},
                                                                     {"curvature", Kind::Curvature},
                                                                     {"thickness", Kind::Thickness},
                                                                     {"deviation", Kind::Deviation}}};

double ofTriangle(Kind kind, const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place, double grain)
{
    if (kind == Kind::Strain) {
        const Eigen::Vector2d strain = principalStretches(rest, place) - Eigen::Vector2d::Ones();
        return strain[0] > -strain[1] ? strain[0] : strain[1];
    }
    const GrainStrain strain = grainStrain(rest, place, grain);
    return kind == Kind::Along ? strain.along : kind == Kind::Across ? strain.across : strain.shear;
}

double allowedOf(Kind kind, const StretchLimits& limits)
{
    switch (kind) {
    case Kind::Along:
        return limits.along;
    case Kind::Across:
        return limits.across;
    case Kind::Shear:
        return limits.shear;
    default:
        return std::min(limits.along, limits.across); // whichever way it runs
    }
}

void measureStrain(CoverMap& map, const SurfaceMesh& surface, const Design& design)
{
    const SurfaceTopology& topology = *surface.topology;
    map.allowed.assign(topology.vertexCount(), 1e30F);
    map.scale.limit = 0.1F; // the least that a fabric may have
    for (const SurfaceTopology::PatchRange& range : topology.patches) {
        const Patch* patch = design.find<Patch>(range.patch);
        const Fabric* fabric = design.find<Fabric>(range.fabric);
        const double grain = (patch ? patch->grain : Patch{}.grain) * std::numbers::pi / 180;
        const double allowed = allowedOf(map.kind, fabric ? fabric->limits : StretchLimits{});
        std::fill_n(map.allowed.begin() + range.firstVertex, range.vertexCount, static_cast<float>(allowed));
        map.scale.limit = std::max(map.scale.limit, static_cast<float>(allowed));
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
            std::array<Vec2, 3> rest;
            std::array<Vec3, 3> place;
            for (std::size_t k = 0; k < 3; ++k) {
                rest[k] = topology.pattern[topology.triangles[t][k]];
                place[k] = surface.positions[topology.triangles[t][k]];
            }
            const auto percent = static_cast<float>(100 * ofTriangle(map.kind, rest, place, grain));
            for (const std::uint32_t v : topology.triangles[t])
                if (std::isfinite(percent) && !(std::abs(map.ofVertex[v]) >= std::abs(percent)))
                    map.ofVertex[v] = percent;
        }
    }
}

void measureCurvature(CoverMap& map, const SurfaceMesh& surface)
{
    map.ofVertex = meanCurvature(surface);
    std::vector<double> sizes;
    for (const float value : map.ofVertex)
        if (std::isfinite(value))
            sizes.push_back(std::abs(static_cast<double>(value)));
    std::ranges::sort(sizes);
    if (!sizes.empty()) // seams and creases are few and sharp
        map.scale.limit = MapScale::usualLimit(std::max(sizes[sizes.size() * 9 / 10], 1.0));
}

void measureThickness(CoverMap& map, const SurfaceMesh& surface, const Design& design, const DesignFiles& files)
{
    FrameDistance frames;
    const TriangleTree* tree = frames.tree(design, files);
    map.scale = {MapScale::Kind::Sequential, 1};
    if (!tree)
        return;
    float most = 1;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const double distance = tree->distance(surface.positions[v], farthestFrame);
        if (!(distance < farthestFrame))
            continue;
        map.ofVertex[v] = static_cast<float>(distance);
        most = std::max(most, map.ofVertex[v]);
    }
    map.scale.limit = MapScale::usualLimit(static_cast<double>(most));
}

void measureDeviation(CoverMap& map, const SurfaceMesh& surface, const Design& design, const DesignFiles& files)
{
    std::optional<ElementId> found;
    bool acts = false;
    design.each<Scan>([&](ElementId id, const Scan& scan) {
        if (files.clouds.contains(id) && (!found || (scan.enabled && !acts))) {
            found = id;
            acts = scan.enabled;
        }
    });
    if (!found)
        return;
    const Scan& scan = *design.find<Scan>(*found);
    const auto index = ScanIndexCache().index(*found, scan, files);
    if (!index || index->empty())
        return;
    WorkerPool here(1);
    ScanDeviation deviation = measureScan(surface, scan, index, here);
    map.ofVertex = std::move(deviation.ofVertex);
    map.scale.limit = MapScale::usualLimit(std::max(deviation.figures.p95, 0.1));
}

} // namespace

std::vector<MapScale::Rgba> CoverMap::colors() const
{
    std::vector<MapScale::Rgba> all;
    all.reserve(ofVertex.size());
    for (std::uint32_t v = 0; v < ofVertex.size(); ++v)
        all.push_back(scale.color(ofVertex[v], allowedAt(v)));
    return all;
}

CoverMap coverMap(CoverMap::Kind kind, const SurfaceMesh& surface, const Design& design, const DesignFiles& files)
{
    CoverMap map;
    map.kind = kind;
    map.ofVertex.assign(surface.positions.size(), unknown);
    if (kind == Kind::Curvature)
        measureCurvature(map, surface);
    else if (kind == Kind::Thickness)
        measureThickness(map, surface, design, files);
    else if (kind == Kind::Deviation)
        measureDeviation(map, surface, design, files);
    else
        measureStrain(map, surface, design);
    return map;
}

std::optional<CoverMap::Kind> coverMapKind(std::string_view word)
{
    const auto found = std::ranges::find(words, word, &std::pair<std::string_view, Kind>::first);
    return found == words.end() ? std::nullopt : std::optional(found->second);
}

std::vector<CoverSpot> worstSpots(const CoverMap& map, const SurfaceMesh& surface, std::size_t most, double apart)
{
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < map.ofVertex.size(); ++v)
        if (std::isfinite(map.ofVertex[v]))
            order.push_back(v);
    const auto badness = [&](std::uint32_t v) {
        return map.allowed.empty() ? std::abs(map.ofVertex[v]) : std::abs(map.ofVertex[v]) / map.allowed[v];
    };
    std::ranges::stable_sort(order, std::ranges::greater(), badness);
    std::vector<CoverSpot> spots;
    for (const std::uint32_t v : order) {
        if (spots.size() >= most)
            break;
        const bool taken = std::ranges::any_of(spots, [&](const CoverSpot& spot) {
            return (surface.positions[spot.vertex] - surface.positions[v]).norm() < apart;
        });
        if (!taken)
            spots.push_back({v, map.ofVertex[v]});
    }
    return spots;
}

} // namespace bolster
