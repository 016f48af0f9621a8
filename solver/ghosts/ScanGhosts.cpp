#include "ScanGhosts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace bolster {

namespace {

// At strength 1: less leaves the scan's shape to the cloth, more follows its noise.
constexpr double usualGamma = 1e4;
// Point spacings that a nearest point may lie aside. Inside a scanned area none lies further; beyond the rim of a
// hole the rim's points would pull the cloth that spans it.
constexpr double widestAside = 1.6;
// Of cover and scan: steeper planes say nothing about the height.
constexpr double leastCosine = 0.5;

/// A power of two, so that moving a slider seldom factors again.
double gammaFactor(double strength)
{
    return static_cast<double>(std::bit_ceil(static_cast<unsigned>(std::ceil(std::max(1.0, strength)))));
}

} // namespace

ScanPlace::ScanPlace(const Scan& scan, std::shared_ptr<const ScanIndex> index)
    : m_placement(scan)
    , m_threshold(scan.threshold)
    , m_widest(widestAside * index->spacing() * scan.scale)
    , m_index(std::move(index))
{}

std::optional<ScanOffset> ScanPlace::offset(int nearest, const Vec3& at, const Vec3& normal, bool limitAside) const
{
    if (nearest < 0)
        return std::nullopt;
    ScanOffset offset;
    offset.whole = m_placement.placed(m_index->point(nearest)) - at;
    offset.along = offset.whole.dot(normal);
    offset.aside = (offset.whole - offset.along * normal).norm();
    // What is a few points wide would lose its depth if a vertex between two points took the height of one of them.
    const Vec3 scanNormal = m_placement.rotation * m_index->normal(nearest);
    if (const double cosine = scanNormal.dot(normal); std::abs(cosine) > leastCosine)
        offset.along = offset.whole.dot(scanNormal) / cosine;
    const bool near = offset.whole.norm() <= m_threshold;
    return near && !(limitAside && offset.aside > m_widest) ? std::optional(offset) : std::nullopt;
}

ScanGhosts::ScanGhosts(const Scan& scan, std::shared_ptr<const ScanIndex> index, const SewnMesh& mesh)
    : m_scan(scan)
    , m_place(scan, std::move(index))
    , m_partOf(static_cast<std::size_t>(mesh.vertexCount()))
    , m_matches(static_cast<std::size_t>(mesh.freeCount))
    , m_nearest(static_cast<std::size_t>(mesh.freeCount))
    , m_displacements(Columns::Zero(4, mesh.vertexCount()))
{
    for (int p = 0; p < std::ssize(mesh.parts); ++p)
        std::fill_n(m_partOf.begin() + mesh.parts[p].firstVertex, mesh.parts[p].vertexCount, p);
}

double ScanGhosts::gamma(const SewnMesh::Part&) const
{
    return usualGamma * gammaFactor(m_scan.strength);
}

void ScanGhosts::follow(const SheetMoment& sheet, WorkerPool& pool)
{
    pool.forChunks(sheet.mesh.freeCount, [&](int, int begin, int end) {
        for (int u = begin; u < end; ++u)
            m_nearest[u] = m_matches[u].follow(m_place.index(), m_place.filePoint(sheet.positions.col(u).head<3>()),
                                               m_place.fileRadius());
    });
    std::vector<Sum> sums(static_cast<std::size_t>(WorkerPool::chunkCount(sheet.mesh.vertexCount())));
    pool.forChunks(sheet.mesh.vertexCount(),
                   [&](int chunk, int begin, int end) { sums[chunk] = pull(sheet, begin, end); });
    Sum total;
    for (const Sum& sum : sums) {
        total.squares += sum.squares;
        total.count += sum.count;
    }
    m_misfit = total.count > 0 ? std::sqrt(total.squares / total.count) : 0;
}

ScanGhosts::Sum ScanGhosts::pull(const SheetMoment& sheet, int begin, int end)
{
    const bool plane = m_scan.target == ScanTarget::Plane;
    const double share = m_scan.strength / gammaFactor(m_scan.strength);
    Sum sum;
    for (int v = begin; v < end; ++v) {
        const auto u = static_cast<int>(sheet.mesh.topology->unknown[v]);
        m_displacements.col(v).setZero();
        if (u >= sheet.mesh.freeCount)
            continue;
        const Vec3 normal = sheet.outside(sheet.mesh.parts[m_partOf[v]], v);
        const auto offset = m_place.offset(m_nearest[u], sheet.position(v), normal, plane);
        if (!offset)
            continue;
        const Vec3 wanted = plane ? Vec3(offset->along * normal) : offset->whole;
        m_displacements.col(v).head<3>() = share * wanted;
        sum.squares += wanted.squaredNorm();
        ++sum.count;
    }
    return sum;
}

void ScanGhosts::displace(const SheetMoment&, const SewnMesh::Part&, int begin, int end,
                          Columns& displacements) const
{
    displacements.middleCols(begin, end - begin) = m_displacements.middleCols(begin, end - begin);
}

} // namespace bolster
