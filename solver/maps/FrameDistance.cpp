#include "FrameDistance.h"

#include "FramePieces.h"
#include "TriangleTree.h"

namespace bolster {

const TriangleTree* FrameDistance::tree(const Design& design, const DesignFiles& files)
{
    decltype(m_of) of;
    design.each<Frame>([&](ElementId id, const Frame& frame) {
        if (const auto mesh = files.meshes.find(id); mesh != files.meshes.end() && mesh->second)
            of.emplace_back(shownMesh(mesh->second, frame.hiddenParts), frame);
    });
    if (of == m_of)
        return m_tree.get();
    m_of = std::move(of);
    std::vector<TriangleTree::Triangle> triangles;
    for (const auto& [mesh, placement] : m_of)
        for (const auto& corners : mesh->triangles) {
            TriangleTree::Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k)
                triangle[k] = placement.placed(mesh->points[corners[k]]);
            triangles.push_back(triangle);
        }
    m_tree = triangles.empty() ? nullptr : std::make_shared<const TriangleTree>(triangles);
    return m_tree.get();
}

} // namespace bolster
