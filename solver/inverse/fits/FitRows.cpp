#include "FitRows.h"

#include "CoverStrains.h"
#include "ScanMeasure.h"
#include "StretchLength.h"
#include "VertexAreas.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace bolster {

namespace {

constexpr double mmOfStrain = 100; // 1 % over the limit counts like 1 mm
constexpr double forgiven = 0.003; // more of that than before, root of the mean over the cover, 1
constexpr double shyOfStrain = 1;  // weight of what the fabrics do not allow, where strain is no goal
constexpr double pressedSooner =
    0.6; // of where stretch counts: else what is too tight is eased by faces going slack
constexpr double meantEase =
    0.005;                       // of the length: sides that differ by more from their ease shall come nearer to it
constexpr double keptLength = 1; // weight of 1 mm between a seam's sides
constexpr double wantedLength = 0.3;
constexpr double freeLength = 0.02;
constexpr double straightWeight = 2;
constexpr double cornerWeight = 50;  // mm: of a radian
constexpr double mostPressed = 0.01; // along the grain or across it, of cloth that lies smooth
constexpr double smoothWeight = 3;   // 1 % pressed together is as bad as so many mm
constexpr double beyondShape = 4;    // weight of 1 mm that the cover goes farther than it may
constexpr double nearlyBeyond = 0.9; // of how far it may go: there that begins
constexpr double sizeWeight = 8;     // 1 % of a patch's width is as bad as so many mm

/// mm: how far a control point of an edge lies to the left of the line between the edge's ends.
double bowAt(const BSpline2& outline, const std::vector<int>& edge, std::size_t k)
{
    const Vec2 from = outline.points()[edge.front()], at = outline.points()[edge[k]] - from;
    const Vec2 way = outline.points()[edge.back()] - from;
    return way.norm() > 0 ? (way.x() * at.y() - way.y() * at.x()) / way.norm() : at.norm();
}

/// Control points of each straight edge, its ends included.
std::vector<std::vector<int>> straightEdges(const BSpline2& outline)
{
    std::vector<std::vector<int>> edges;
    std::vector<int> ends;
    for (const double corner : outline.corners())
        ends.push_back(outline.pointAt(corner));
    for (std::size_t k = 0; k < ends.size(); ++k) {
        std::vector<int> edge{ends[k]};
        const int last = ends[(k + 1) % ends.size()];
        for (int i = ends[k]; i != last || edge.size() == 1;) {
            i = (i + 1) % outline.pointCount();
            edge.push_back(i);
            if (std::ssize(edge) > outline.pointCount())
                break;
        }
        const double within =
            FitLocks::straightWithin((outline.points()[edge.back()] - outline.points()[edge.front()]).norm());
        bool isStraight = edge.size() > 2;
        for (std::size_t i = 1; i + 1 < edge.size(); ++i)
            isStraight = isStraight && std::abs(bowAt(outline, edge, i)) < within;
        if (isStraight)
            edges.push_back(std::move(edge));
    }
    return edges;
}

double cornerAngle(const BSpline2& outline, double corner)
{
    const double small = 1e-6 * outline.period();
    const Vec2 in = outline.derivative(outline.wrapped(corner - small)), out = outline.derivative(corner);
    return std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
}

/// Of the cover that its vertices stand for, mm^2; 0 for those that are not in an area.
std::vector<double> areasIn(const SurfaceMesh& surface, const FitArea& area)
{
    std::vector<double> areas = vertexAreas(*surface.topology, surface.positions);
    for (const SurfaceTopology::PatchRange& range : surface.topology->patches)
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v)
            if (!area.has(range.patch, surface.topology->pattern[v]))
                areas[v] = 0;
    return areas;
}

/// Triangles whose middles lie in an area.
std::vector<std::uint32_t> trianglesIn(const SurfaceTopology& topology, const Design& design, const FitArea& area)
{
    std::vector<std::uint32_t> triangles;
    for (const SurfaceTopology::PatchRange& range : topology.patches) {
        if (!design.find<Patch>(range.patch) || !area.hasAny(range.patch))
            continue;
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
            const auto& corners = topology.triangles[t];
            const Vec2 sum =
                topology.pattern[corners[0]] + topology.pattern[corners[1]] + topology.pattern[corners[2]];
            if (area.has(range.patch, sum / 3))
                triangles.push_back(t);
        }
    }
    return triangles;
}

double pressedShare(const CoverStrains& strains)
{
    double pressed = 0;
    for (Eigen::Index t = 0; t < strains.areas.size(); ++t)
        if (strains.strains.col(t).head<2>().minCoeff() < -mostPressed)
            pressed += strains.areas[t];
    const double all = strains.areas.sum();
    return all > 0 ? pressed / all : 0;
}

} // namespace

double seamDifference(const Design& design, const Seam& seam)
{
    return stretchLength(design, seam.b) - stretchLength(design, seam.a);
}

FitRows::FitRows(const FitGoals& goals, const FitLocks& locks, const Design& design)
    : m_goals(goals)
    , m_locks(locks)
    , m_design(design)
    , m_seams(goals.seams, design)
{
    const std::vector<double> differences = lengthDifferences(design);
    std::size_t k = 0;
    design.each<Seam>([&](ElementId, const Seam& seam) {
        const double now = differences[k++];
        const bool meant = std::abs(now - seam.ease) <= meantEase * stretchLength(design, seam.a);
        if (!locks.ease)
            m_wanted.push_back({now, freeLength});
        else
            m_wanted.push_back(meant ? Wanted{now, keptLength} : Wanted{seam.ease, wantedLength});
    });
}

void FitRows::aim(const WarmCover& cover)
{
    m_aims.clear();
    addAims(cover, m_goals.target, m_goals.targetWeight, false);
    m_keptFirst = m_aims.size();
    if (m_goals.keepShape > 0)
        addAims(cover, m_kept, m_goals.keepShape, true);
    m_seams.aim(cover);
    m_strained = trianglesIn(*cover.mesh().topology, m_design, m_goals.area);
    m_smoothed = trianglesIn(*cover.mesh().topology, m_design, {m_goals.smooth, {}});
}

void FitRows::addAims(const WarmCover& cover, const FitTarget& target, double weight, bool everywhere)
{
    if (target.empty())
        return;
    const SurfaceMeshPtr surface = cover.surface();
    WorkerPool pool(0);
    const ScanDeviation deviation = measureScan(*surface, target.place, target.index, pool);
    const std::vector<double> areas = areasIn(*surface, everywhere ? FitArea() : m_goals.area);
    const std::size_t first = m_aims.size();
    double all = 0;
    for (std::size_t v = 0; v < areas.size(); ++v) {
        if (std::isnan(deviation.ofVertex[v]) || !(areas[v] > 0))
            continue;
        const Vec3 normal = surface->normals[v].cast<double>();
        m_aims.push_back(
            {static_cast<int>(v), normal, normal.dot(surface->positions[v]) - deviation.ofVertex[v], areas[v]});
        all += areas[v];
    }
    for (std::size_t k = first; k < m_aims.size(); ++k)
        m_aims[k].weight = weight * std::sqrt(m_aims[k].weight / all);
}

void FitRows::keep(const WarmCover& cover)
{
    TriangleMesh mesh;
    mesh.points = vertexPlaces(cover);
    mesh.triangles = cover.mesh().topology->triangles;
    m_kept = targetOf(mesh);
    m_unwanted = unwantedStrain(*cover.mesh().topology, mesh.points);
}

void FitRows::addStrain(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                        std::vector<double>& rows) const
{
    const CoverStrains found = coverStrains(topology, places, m_design, m_goals.limit, m_strained);
    const double all = found.areas.sum();
    for (Eigen::Index t = 0; t < found.areas.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const double from = k < 2 && found.strains(k, t) < 0 ? pressedSooner * m_strainFrom : m_strainFrom;
            const double over = std::max(0.0, std::abs(found.strains(k, t)) - from * found.limits(k, t));
            rows.push_back(m_goals.strainWeight * mmOfStrain * std::copysign(over, found.strains(k, t)) *
                           std::sqrt(found.areas[t] / all));
        }
}

/// How much each patch is strained over what its fabric allows: root of the share that is its of the mean square
/// over the cover, 1. Of every fourth triangle: it is a mean, and is asked for as often as there are freedoms.
std::vector<double> FitRows::unwantedStrain(const SurfaceTopology& topology, const std::vector<Vec3>& places) const
{
    constexpr std::uint32_t apart = 4;
    std::vector<std::uint32_t> triangles;
    std::vector<Eigen::Index> ends;
    for (const SurfaceTopology::PatchRange& range : topology.patches) {
        for (std::uint32_t t = 0; m_design.find<Patch>(range.patch) && t < range.triangleCount; t += apart)
            triangles.push_back(range.firstTriangle + t);
        ends.push_back(std::ssize(triangles));
    }
    const CoverStrains found = coverStrains(topology, places, m_design, std::nullopt, triangles);
    const Eigen::VectorXd squares = squaresOver(found, found.strains).cwiseProduct(found.areas);
    std::vector<double> ofPatch;
    Eigen::Index first = 0;
    for (const Eigen::Index end : ends) {
        ofPatch.push_back(std::sqrt(squares.segment(first, end - first).sum() / found.areas.sum()));
        first = end;
    }
    return ofPatch;
}

/// A form is not worth any strain: no patch shall be strained over its fabric's limits by more than it was.
void FitRows::addShyness(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                         std::vector<double>& rows) const
{
    const std::vector<double> now = unwantedStrain(topology, places);
    for (std::size_t k = 0; k < now.size(); ++k)
        rows.push_back(shyOfStrain * mmOfStrain *
                       std::max(0.0, now[k] - forgiven - (k < m_unwanted.size() ? m_unwanted[k] : 0)));
}

void FitRows::addSmooth(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                        std::vector<double>& rows) const
{
    const CoverStrains found = coverStrains(topology, places, m_design, std::nullopt, m_smoothed);
    const double all = found.areas.sum();
    for (Eigen::Index t = 0; t < found.areas.size(); ++t)
        for (int k = 0; k < 2; ++k) // along the grain and across it
            rows.push_back(smoothWeight * mmOfStrain * std::min(0.0, found.strains(k, t) + mostPressed) *
                           std::sqrt(found.areas[t] / all));
}

double FitRows::sizeOff(const Design& design, const SizeGoal& goal) const
{
    const auto *before = m_design.find<Patch>(goal.patch), *now = design.find<Patch>(goal.patch);
    if (!before || !now)
        return 0;
    return now->outline.signedArea() / (goal.share * before->outline.signedArea()) - 1;
}

void FitRows::addSizes(const Design& design, std::vector<double>& rows) const
{
    for (const SizeGoal& goal : m_goals.sizes)
        rows.push_back(sizeWeight * 100 / 2 *
                       sizeOff(design, goal)); // the width is off by half of the area's share
}

std::vector<double> FitRows::lengthDifferences(const Design& design) const
{
    std::vector<double> differences;
    design.each<Seam>([&](ElementId, const Seam& seam) { differences.push_back(seamDifference(design, seam)); });
    return differences;
}

void FitRows::addPattern(const Design& design, std::vector<double>& rows) const
{
    if (m_locks.lengths) {
        const std::vector<double> now = lengthDifferences(design);
        for (std::size_t k = 0; k < now.size() && k < m_wanted.size(); ++k)
            rows.push_back(m_wanted[k].weight * (now[k] - m_wanted[k].difference));
    }
    m_design.each<Patch>([&](ElementId id, const Patch& before) {
        const auto* patch = design.find<Patch>(id);
        if (!patch)
            return;
        if (m_locks.straight)
            for (const std::vector<int>& edge : straightEdges(before.outline))
                for (std::size_t k = 1; k + 1 < edge.size(); ++k)
                    rows.push_back(straightWeight *
                                   (bowAt(patch->outline, edge, k) - bowAt(before.outline, edge, k)));
        if (m_locks.corners)
            for (const double corner : before.outline.corners())
                rows.push_back(cornerWeight *
                               (cornerAngle(patch->outline, corner) - cornerAngle(before.outline, corner)));
    });
}

Eigen::VectorXd FitRows::rows(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                              const Design& design) const
{
    std::vector<double> rows;
    for (const Aim& aim : m_aims)
        rows.push_back(aim.weight * (aim.normal.dot(places[aim.vertex]) - aim.height));
    if (m_goals.keepShape > 0 && m_goals.isLimitAlone()) {
        const std::span kept = std::span(rows).subspan(m_keptFirst);
        const double rms =
            std::sqrt(std::inner_product(kept.begin(), kept.end(), kept.begin(), 0.0)) / m_goals.keepShape;
        rows.push_back(beyondShape * std::max(0.0, rms - nearlyBeyond * m_goals.shapeWithin));
    }
    if (m_goals.strain)
        addStrain(topology, places, rows);
    else if (!m_goals.target.empty())
        addShyness(topology, places, rows);
    if (!m_goals.smooth.empty())
        addSmooth(topology, places, rows);
    m_seams.add(places, rows);
    addSizes(design, rows);
    addPattern(design, rows);
    return Eigen::Map<Eigen::VectorXd>(rows.data(), std::ssize(rows));
}

FitFigures FitRows::figures(const WarmCover& cover, const Design& design) const
{
    FitFigures figures;
    const std::vector<Vec3> places = vertexPlaces(cover);
    WorkerPool pool(0);
    const SurfaceMeshPtr surface = cover.surface();
    if (!m_goals.target.empty()) {
        const ScanDeviation deviation = measureScan(*surface, m_goals.target.place, m_goals.target.index, pool);
        const ScanFigures found = scanFigures(deviation.ofVertex, areasIn(*surface, m_goals.area));
        figures.distanceRms = found.rms;
        figures.distanceP95 = found.p95;
        figures.covered = found.coverage;
    }
    if (!m_kept.empty())
        figures.shapeRms = measureScan(*surface, m_kept.place, m_kept.index, pool).figures.rms;
    const SurfaceTopology& topology = *cover.mesh().topology;
    // What fabrics do not allow counts everywhere, unless strain is what the area is about.
    const CoverStrains found =
        coverStrains(topology, places, m_design, m_goals.limit,
                     trianglesIn(topology, m_design, m_goals.strain ? m_goals.area : FitArea()));
    figures.overLimit = bolster::overLimit(found).area;
    if (const double all = found.areas.sum(); all > 0)
        figures.strainRms =
            std::sqrt(found.strains.topRows(2).colwise().squaredNorm().dot(found.areas) / (2 * all));
    if (!m_goals.smooth.empty())
        figures.pressed = pressedShare(coverStrains(topology, places, m_design, std::nullopt,
                                                    trianglesIn(topology, m_design, {m_goals.smooth, {}})));
    if (!m_seams.empty())
        figures.seamRms = m_seams.rms(cover);
    for (const SizeGoal& goal : m_goals.sizes)
        figures.sizeMost = std::max(figures.sizeMost, std::abs(sizeOff(design, goal)));
    const std::vector<double> now = lengthDifferences(design);
    for (std::size_t k = 0; k < now.size() && k < m_wanted.size(); ++k)
        figures.sewnMost = std::max(figures.sewnMost, std::abs(now[k] - m_wanted[k].difference));
    return figures;
}

} // namespace bolster
