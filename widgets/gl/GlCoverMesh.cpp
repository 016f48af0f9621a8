#include "GlCoverMesh.h"

#include "FewerTriangles.h"
#include "SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bolster {

GlCoverMesh::GlCoverMesh(GlFunctions& gl)
    : m_gl(gl)
{
    m_array.create();
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    bindColumns(gl, m_positions, 3 * sizeof(float), {{0, 3, GL_FLOAT, 0}});
    bindColumns(gl, m_normals, 3 * sizeof(float), {{1, 3, GL_FLOAT, 0}});
    bindColumns(gl, m_cloth, 2 * sizeof(float), {{2, 2, GL_FLOAT, 0}});
    bindColumns(gl, m_openness, 2 * sizeof(float), {{3, 2, GL_FLOAT, 0}});
    bindColumns(gl, m_mapColors, sizeof(VertexMap::Rgba), {{4, 4, GL_UNSIGNED_BYTE, 0}});
    bindColumns(gl, m_seamDistances, 3 * sizeof(float), {{5, 3, GL_FLOAT, 0}});
    bindColumns(gl, m_seamShapes, 2 * sizeof(float), {{6, 2, GL_FLOAT, 0}});
}

template <class T>
std::vector<T> GlCoverMesh::ofVertices(std::vector<T> ofCoarse) const
{
    return m_fine ? m_fine->carriedOver(ofCoarse) : std::move(ofCoarse);
}

void GlCoverMesh::forget()
{
    m_surface.reset();
    m_cover.reset();
    m_coarse.reset();
    m_fine.reset();
}

void GlCoverMesh::put(const SurfaceMeshPtr& surface)
{
    if (surface == m_surface)
        return;
    if (!surface) {
        forget();
        return;
    }
    if (surface->topology != m_coarse) {
        m_coarse = surface->topology;
        std::vector<Eigen::Vector2f> cloth;
        for (const Vec2& p : m_coarse->pattern)
            cloth.push_back(p.cast<float>());
        putTopology(cloth, m_coarse->triangles);
    }
    m_surface = surface;
    std::vector<Eigen::Vector3f> positions;
    positions.reserve(surface->positions.size());
    for (const Vec3& p : surface->positions)
        positions.push_back(p.cast<float>());
    m_positions.put(positions, QOpenGLBuffer::StreamDraw);
    m_normals.put(surface->normals, QOpenGLBuffer::StreamDraw);
}

void GlCoverMesh::put(const CoverMeshPtr& cover)
{
    if (cover == m_cover)
        return;
    if (!cover) {
        forget();
        return;
    }
    if (cover->topology != m_fine) {
        m_fine = cover->topology;
        m_coarse = m_fine->coarse;
        putTopology(m_fine->pattern, m_fine->triangles);
    }
    m_cover = cover;
    m_positions.put(cover->points, QOpenGLBuffer::StreamDraw);
    m_normals.put(cover->normals, QOpenGLBuffer::StreamDraw);
}

void GlCoverMesh::putTopology(const std::vector<Eigen::Vector2f>& cloth,
                              const std::vector<CoverTopology::Triangle>& all)
{
    m_cloth.put(cloth, QOpenGLBuffer::StaticDraw);
    m_openness.put(std::vector<Eigen::Vector2f>(cloth.size(), {1, 1}), QOpenGLBuffer::DynamicDraw);
    m_mapColors.put(std::vector<VertexMap::Rgba>(cloth.size()), QOpenGLBuffer::DynamicDraw);
    m_map.reset();
    m_occlusion.reset();
    m_relief.reset();
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    m_triangles.put(all, QOpenGLBuffer::StaticDraw);
    m_coarseTriangles.put(m_coarse->triangles, QOpenGLBuffer::StaticDraw);
    m_fewerOf.clear();
    m_edgeCount = 0;
}

/// Once for each topology, when something moves.
void GlCoverMesh::putFewer()
{
    if (!m_fewerOf.empty())
        return;
    FewerTriangles fewer = fewerTriangles(*m_coarse, mostMovingTriangles);
    m_fewerTriangles.put(fewer.triangles, QOpenGLBuffer::StaticDraw);
    m_fewerOf = std::move(fewer.firstOf);
}

void GlCoverMesh::putMap(const VertexMapPtr& map)
{
    if (!m_coarse || map == m_map)
        return;
    m_map = map;
    const bool fits = map && map->fits(*m_coarse) && map->values.size() == m_coarse->vertexCount();
    std::vector<VertexMap::Rgba> colors(m_fine ? m_fine->vertexCount() : m_coarse->vertexCount());
    if (fits) {
        // Colours are carried over, not values: where stretched meets pressed these would pass through zero.
        std::vector<Eigen::Vector4f> ofCoarse;
        for (const auto& [r, g, b, a] : map->colors())
            ofCoarse.emplace_back(r, g, b, a);
        const std::vector<Eigen::Vector4f> shown = ofVertices(std::move(ofCoarse));
        for (std::size_t v = 0; v < colors.size(); ++v)
            for (int c = 0; c < 4; ++c)
                colors[v][static_cast<std::size_t>(c)] =
                    static_cast<std::uint8_t>(std::clamp(std::lround(shown[v][c]), 0L, 255L));
    }
    m_mapColors.put(colors, QOpenGLBuffer::DynamicDraw);
}

void GlCoverMesh::putOpenness(const std::shared_ptr<const CoverOcclusion>& occlusion)
{
    if (!m_coarse || occlusion == m_occlusion)
        return;
    m_occlusion = occlusion;
    if (!occlusion || occlusion->topology != m_coarse->serial ||
        occlusion->outside.size() != m_coarse->vertexCount())
        return;
    std::vector<Eigen::Vector2f> openness;
    openness.reserve(occlusion->outside.size());
    for (std::size_t i = 0; i < occlusion->outside.size(); ++i)
        openness.push_back({occlusion->outside[i], occlusion->inside[i]});
    m_openness.put(ofVertices(std::move(openness)), QOpenGLBuffer::DynamicDraw);
}

void GlCoverMesh::putRelief(const SeamReliefPtr& relief)
{
    if (!m_coarse || relief == m_relief)
        return;
    m_relief = relief;
    m_seamDistances.put(relief->distances, QOpenGLBuffer::StaticDraw); // what follows the solver's is not used
    m_seamShapes.put(relief->shapes, QOpenGLBuffer::StaticDraw);
}

GlCoverMesh::Ranges GlCoverMesh::patches(const SurfaceTopology& shown) const
{
    if (!m_fine)
        return shown.patches; // its triangles are those of the patches that are shown
    Ranges ranges;
    for (const SurfaceTopology::PatchRange& range : m_coarse->patches)
        if (std::ranges::find(shown.patches, range.patch, &SurfaceTopology::PatchRange::patch) !=
            shown.patches.end())
            ranges.push_back(range);
    return ranges;
}

void GlCoverMesh::draw(const Ranges& patches, const std::function<void(const SurfaceTopology::PatchRange&)>& begin,
                       Detail detail)
{
    const bool fewer = detail == Detail::Fewer && tooManyToMove(m_coarse->triangles.size());
    const bool refined = detail == Detail::Refined;
    const std::size_t each = m_fine && refined ? m_fine->trianglesPerCoarse() : 1;
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    if (fewer)
        putFewer();
    (fewer ? m_fewerTriangles : refined ? m_triangles : m_coarseTriangles).bind();
    for (const SurfaceTopology::PatchRange& range : patches) {
        begin(range);
        std::size_t first = each * range.firstTriangle, count = each * range.triangleCount;
        if (fewer) {
            const auto place =
                std::ranges::lower_bound(m_coarse->patches, range.patch, {}, &SurfaceTopology::PatchRange::patch) -
                m_coarse->patches.begin();
            first = m_fewerOf[static_cast<std::size_t>(place)];
            count = m_fewerOf[static_cast<std::size_t>(place) + 1] - first;
        }
        m_gl.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(3 * sizeof(std::uint32_t) * first));
    }
}

void GlCoverMesh::putEdges(const Ranges& patches)
{
    std::vector<SurfaceEdge> edges;
    for (const SurfaceTopology::PatchRange& patch : patches)
        std::ranges::copy(edgesOf(*m_coarse, patch), std::back_inserter(edges));
    if (m_fine) {
        std::vector<SurfaceEdge> parts;
        for (const SurfaceEdge& edge : edges) {
            const std::vector<std::uint32_t> along = m_fine->along(edge);
            for (std::size_t i = 1; i < along.size(); ++i)
                parts.push_back({along[i - 1], along[i]});
        }
        edges = std::move(parts);
    }
    m_edges.put(edges, QOpenGLBuffer::StaticDraw);
    m_edgeCount = static_cast<GLsizei>(2 * edges.size());
}

void GlCoverMesh::drawEdges(const Ranges& patches)
{
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    std::vector<ElementId> ids;
    for (const SurfaceTopology::PatchRange& patch : patches)
        ids.push_back(patch.patch);
    if (m_edgeCount == 0 || ids != m_edgesOf)
        putEdges(patches);
    m_edgesOf = std::move(ids);
    m_edges.bind();
    m_gl.glDrawElements(GL_LINES, m_edgeCount, GL_UNSIGNED_INT, nullptr);
}

} // namespace bolster
