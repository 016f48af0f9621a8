#include "ScanMeasure.h"

#include "ScanGhosts.h"
#include "VertexAreas.h"

#include <algorithm>
#include <cmath>

namespace bolster {

ScanFigures scanFigures(const std::vector<float>& deviations, const std::vector<double>& areas)
{
    std::vector<std::pair<double, double>> sizes; // with their areas
    double all = 0, measured = 0, squares = 0;
    for (std::size_t v = 0; v < areas.size(); ++v) {
        all += areas[v];
        if (std::isnan(deviations[v]) || !(areas[v] > 0))
            continue;
        sizes.emplace_back(std::abs(deviations[v]), areas[v]);
        measured += areas[v];
        squares += areas[v] * deviations[v] * deviations[v];
    }
    ScanFigures figures;
    if (!(measured > 0))
        return figures;
    std::sort(sizes.begin(), sizes.end());
    double sum = 0;
    for (const auto& [size, area] : sizes) {
        figures.median = sum < 0.5 * measured ? size : figures.median;
        figures.p95 = sum < 0.95 * measured ? size : figures.p95;
        sum += area;
    }
    figures.max = sizes.back().first;
    figures.rms = std::sqrt(squares / measured);
    figures.coverage = measured / all;
    return figures;
}

ScanDeviation measureScan(const SurfaceMesh& surface, const Scan& scan, std::shared_ptr<const ScanIndex> index,
                          WorkerPool& pool)
{
    ScanDeviation result;
    const int count = static_cast<int>(surface.positions.size());
    result.ofVertex.assign(surface.positions.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<Vec3> points(surface.positions.size());
    const ScanPlace place(scan, std::move(index));
    pool.forChunks(count, [&](int, int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const Vec3& at = surface.positions[v];
            const int nearest = place.index().search(place.filePoint(at), place.fileRadius()).first;
            if (const auto offset = place.offset(nearest, at, surface.normals[v].cast<double>(), true)) {
                result.ofVertex[v] = static_cast<float>(-offset->along);
                points[v] = at + offset->whole;
            }
        }
    });
    for (std::size_t v = 0; v < points.size(); ++v)
        if (!std::isnan(result.ofVertex[v]))
            result.pairs.emplace_back(static_cast<std::uint32_t>(v), points[v]);
    result.figures = scanFigures(result.ofVertex, vertexAreas(*surface.topology, surface.positions));
    result.figures.points = place.index().size();
    return result;
}

std::vector<SolveReport::ScanFit> measureScans(const SolveInput& input, const SurfaceMesh& surface,
                                               ScanIndexCache& cache, WorkerPool& pool)
{
    std::vector<SolveReport::ScanFit> fits;
    input.design.each<Scan>([&](ElementId id, const Scan& scan) {
        auto index = cache.index(id, scan, input.files);
        if (!index || index->empty())
            return;
        fits.push_back({id, scan.name, measureScan(surface, scan, std::move(index), pool).figures});
    });
    return fits;
}

} // namespace bolster
