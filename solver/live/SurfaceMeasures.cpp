#include "SurfaceMeasures.h"

#include "Relaxation.h"
#include "Relief.h"
#include "SegmentDistance.h"
#include "TriangleStrain.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

struct Weighted {
    double value = 0;
    double weight = 0;
};

/// The value that 99 % of the weight do not exceed.
double percentile99(std::vector<Weighted> values)
{
    std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    double total = 0;
    for (const Weighted& v : values)
        total += v.weight;
    double sum = 0;
    for (const Weighted& v : values)
        if ((sum += v.weight) >= 0.99 * total)
            return v.value;
    return 0;
}

void measureTriangles(const SewnMesh& mesh, const SheetState& state, const std::vector<Vec3>& positions,
                      SolveReport& report)
{
    const SurfaceTopology& topology = *mesh.topology;
    std::vector<Weighted> strains;
    double squares = 0;
    for (std::size_t p = 0; p < topology.patches.size(); ++p) {
        const SurfaceTopology::PatchRange& range = topology.patches[p];
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
            std::array<Vec2, 3> rest;
            std::array<Vec3, 3> place;
            Vec3 frameNormal = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t v = topology.triangles[t][k];
                rest[k] = topology.pattern[v];
                place[k] = positions[v];
                frameNormal += mesh.parts[p].outward * rotationOf(state.frames.col(v)).col(2);
            }
            const Vec2 u = rest[1] - rest[0], v = rest[2] - rest[0];
            const double restArea = 0.5 * std::abs(u.x() * v.y() - u.y() * v.x());
            const Vec3 normal = (place[1] - place[0]).cross(place[2] - place[0]);
            const Eigen::Vector2d strain = principalStretches(rest, place) - Eigen::Vector2d::Ones();
            report.restArea += restArea;
            report.area += 0.5 * normal.norm();
            report.flippedTriangles += normal.dot(frameNormal) < 0;
            squares += 0.5 * restArea * strain.squaredNorm();
            strains.push_back({strain.cwiseAbs().maxCoeff(), restArea});
            report.strain.max = std::max(report.strain.max, strains.back().value);
        }
    }
    report.strain.p99 = percentile99(std::move(strains));
    report.strain.rms = report.restArea > 0 ? std::sqrt(squares / report.restArea) : 0;
}

void addTo(SolveReport::MaxMean& measure, double value, std::int64_t& count)
{
    measure.max = std::max(measure.max, value);
    measure.mean += (value - measure.mean) / static_cast<double>(++count);
}

void measureSeams(const SewnMesh& mesh, const std::vector<Vec3>& positions, SolveReport& report)
{
    const SurfaceTopology& topology = *mesh.topology;
    for (const SurfaceTopology::Chain& chain : topology.seams)
        for (std::size_t k = 0; k < chain.a.size(); ++k) {
            const Vec3 gap = positions[chain.a[k]] - positions[chain.b[k]];
            addTo(report.seamGap, gap.norm(), report.constraints.sewn);
        }
}

void measureFixations(const PreparedSheet& sheet, const std::vector<Vec3>& positions, SolveReport& report)
{
    constexpr int probes = 8;
    std::int64_t count = 0;
    for (const auto& chain : sheet.sampling.fixations) {
        const BSpline3& curve = sheet.design.find<FixationCurve>(chain.curve)->curve;
        const int first = sheet.mesh.parts[chain.outline].firstVertex;
        auto place = [&](std::size_t k) { return positions[first + chain.samples[k]]; };
        for (std::size_t k = 0; k < chain.samples.size(); ++k) {
            addTo(report.fixationError, (place(k) - chain.targets[k]).norm(), count);
            if (k == 0)
                continue;
            const double t0 = chain.curveParameters[k - 1], t1 = chain.curveParameters[k];
            for (int probe = 1; probe < probes; ++probe) {
                const Vec3 p = curve.at(t0 + (t1 - t0) * probe / probes);
                report.fixationDeviation =
                    std::max(report.fixationDeviation, segmentDistance(p, place(k - 1), place(k)));
            }
        }
    }
}

void measureHandles(const PreparedSheet& sheet, const std::vector<Vec3>& positions, SolveReport& report)
{
    for (const auto& chain : sheet.sampling.handles) {
        const SurfaceTopology::Line& line =
            sheet.mesh.topology->lines[sheet.mesh.firstLine[chain.outline] + chain.line];
        double error = 0;
        for (std::size_t k = 0; k < chain.targets.size(); ++k)
            error = std::max(error, (positions[line.vertices[k]] - chain.targets[k]).norm());
        report.handles.push_back({chain.curve, error});
    }
}

void measureFancySeams(const SewnMesh& mesh, SolveReport& report)
{
    for (const SewnMesh::Relief& relief : mesh.reliefs) {
        double share = 0;
        for (const SewnMesh::Relief::Point& point : relief.points)
            share = std::max(share, point.share * fancyProfile(relief.profile, point.across));
        report.fancySeams.push_back({relief.seam, relief.depth * share});
    }
}

} // namespace

SolveReport measureSurface(const PreparedSheet& sheet, const SheetState& state)
{
    SolveReport report;
    const SewnMesh& mesh = sheet.mesh;
    report.vertices = mesh.unknownCount();
    report.triangles = static_cast<std::int64_t>(mesh.topology->triangles.size());
    report.patches = static_cast<std::int64_t>(mesh.parts.size());
    report.seams = static_cast<std::int64_t>(mesh.topology->seams.size());
    report.constraints.fixed = static_cast<std::int64_t>(mesh.targets.size());
    const std::vector<Vec3> positions = coverPositions(mesh, state);
    measureTriangles(mesh, state, positions, report);
    measureSeams(mesh, positions, report);
    measureFixations(sheet, positions, report);
    measureHandles(sheet, positions, report);
    measureFancySeams(mesh, report);
    return report;
}

SolveReport reportOn(const PreparedSheet& sheet, const Relaxation& relaxation)
{
    SolveReport report = measureSurface(sheet, relaxation.state());
    report.iterations = relaxation.iterations();
    report.movement = relaxation.movement();
    relaxation.reportGhosts(report);
    SolveReport::Times& time = report.time;
    time.triangulate = sheet.triangulateTime;
    time.assemble = sheet.assembleTime;
    time.factor = relaxation.factorTime();
    time.iterate = relaxation.iterateTime();
    time.perIteration = time.iterate / std::max(1, report.iterations);
    time.total = time.triangulate + time.assemble + time.factor + time.iterate;
    return report;
}

} // namespace bolster
