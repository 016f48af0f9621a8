#include "VisibleCover.h"

#include <algorithm>

namespace bolster {

namespace {

class Filter {
public:
    Filter(const SurfaceTopology& whole, const std::set<ElementId>& hidden)
        : m_whole(whole)
        , m_hidden(hidden)
        , m_gone(whole.vertexCount(), 0)
    {
        for (const SurfaceTopology::PatchRange& range : whole.patches)
            if (hidden.contains(range.patch))
                std::fill_n(m_gone.begin() + range.firstVertex, range.vertexCount, char{1});
    }

    std::shared_ptr<const SurfaceTopology> visible() const
    {
        auto result = std::make_shared<SurfaceTopology>(m_whole);
        result->triangles.clear();
        result->patches.clear();
        for (SurfaceTopology::PatchRange range : m_whole.patches) {
            if (range.vertexCount > 0 && m_gone[range.firstVertex])
                continue;
            const auto first = m_whole.triangles.begin() + range.firstTriangle;
            range.firstTriangle = static_cast<std::uint32_t>(result->triangles.size());
            result->triangles.insert(result->triangles.end(), first, first + range.triangleCount);
            result->patches.push_back(range);
        }
        const auto chainGone = [this](const SurfaceTopology::Chain& chain) {
            return gone(chain.a) || gone(chain.b);
        };
        std::erase_if(result->seams, chainGone);
        std::erase_if(result->fixations, chainGone);
        std::erase_if(result->lines, [this](const SurfaceTopology::Line& line) {
            return m_hidden.contains(line.element) || gone(line.vertices);
        });
        return result;
    }

private:
    bool gone(const std::vector<std::uint32_t>& vertices) const
    {
        return !vertices.empty() && m_gone[vertices.front()];
    }

    const SurfaceTopology& m_whole;
    const std::set<ElementId>& m_hidden;
    std::vector<char> m_gone; ///< per vertex
};

} // namespace

SurfaceMeshPtr VisibleCover::of(const SurfaceMeshPtr& cover, const std::set<ElementId>& hidden)
{
    const auto isHidden = [&](ElementId id) { return hidden.contains(id); };
    if (!cover || (std::ranges::none_of(cover->topology->patches, isHidden, &SurfaceTopology::PatchRange::patch) &&
                   std::ranges::none_of(cover->topology->lines, isHidden, &SurfaceTopology::Line::element)))
        return cover;
    if (cover->topology != m_whole || hidden != m_hidden) {
        m_whole = cover->topology;
        m_hidden = hidden;
        m_visible = Filter(*m_whole, hidden).visible();
        m_of.reset();
    }
    if (cover != m_of) {
        auto visible = std::make_shared<SurfaceMesh>(*cover);
        visible->topology = m_visible;
        m_of = cover;
        m_shown = std::move(visible);
    }
    return m_shown;
}

TrimMeshPtr visibleTrims(const TrimMeshPtr& trims, const std::set<ElementId>& hidden)
{
    const auto gone = [&](const TrimMesh::Part& part) {
        return hidden.contains(part.element) || hidden.contains(part.patch) || hidden.contains(part.other);
    };
    if (!trims || std::ranges::none_of(trims->parts, gone))
        return trims;
    auto visible = std::make_shared<TrimMesh>(*trims);
    visible->triangles.clear();
    visible->parts.clear();
    for (TrimMesh::Part part : trims->parts) {
        if (gone(part))
            continue;
        const auto first = trims->triangles.begin() + part.firstTriangle;
        part.firstTriangle = static_cast<std::uint32_t>(visible->triangles.size());
        visible->triangles.insert(visible->triangles.end(), first, first + part.triangleCount);
        visible->parts.push_back(part);
    }
    return visible;
}

} // namespace bolster
