#include "FoamMeshes.h"

#include "FoamShape.h"
#include "Selection.h"

namespace bolster {

void FoamMeshes::update(const Design& design, const DesignFiles& files)
{
    std::map<ElementId, MeshPtr> meshes;
    std::map<ElementId, std::pair<Foam::Shape, Vec3>> shapes;
    design.each<Foam>([&](ElementId id, const Foam& foam) {
        if (foam.shape == Foam::Shape::Mesh) {
            if (const auto file = files.meshes.find(id); file != files.meshes.end() && file->second)
                meshes[id] = file->second;
            return;
        }
        const auto& shape = shapes[id] = {foam.shape, foam.size};
        const auto known = m_shapes.find(id);
        meshes[id] = known != m_shapes.end() && known->second == shape
                         ? m_meshes.at(id)
                         : std::make_shared<const TriangleMesh>(foamMesh(foam.shape, foam.size));
    });
    m_meshes = std::move(meshes);
    m_shapes = std::move(shapes);
}

void FoamMeshes::addLines(const Design& design, const Selection& selection, ViewScene& scene) const
{
    for (const auto& [id, mesh] : m_meshes) {
        const Foam* foam = design.find<Foam>(id);
        if (!foam)
            continue;
        const bool selected = selection.contains(id), hovered = selection.hovered() == id;
        const auto lines =
            foam->shape == Foam::Shape::Mesh ? boxLines(mesh->boundingBox()) : foamLines(foam->shape, foam->size);
        for (const std::vector<Vec3>& points : lines) {
            SceneLine line;
            for (const Vec3& p : points)
                line.points.push_back(foam->placed(p).cast<float>());
            line.color = selected    ? scene.colors.accent
                         : foam->cut ? QColor(0xc9, 0x4f, 0x44)
                                     : QColor(0xd9, 0x9a, 0x2b);
            line.width = selected || hovered ? 2.4F : 1.4F;
            line.hidden = selected || hovered ? 0.7F : 0.4F;
            scene.lines.push_back(std::move(line));
        }
    }
}

} // namespace bolster
