#include "ShownScans.h"

#include "SceneVisibility.h"
#include "Selection.h"

namespace bolster {

namespace {

void cutLook(ViewScene::PointsLook& look, const SectionPlane& section)
{
    if (look.own) {
        std::vector<std::uint32_t> own;
        for (std::size_t i = 0; i < look.own->size(); ++i)
            if (section.keeps((*look.points)[i].cast<double>()))
                own.push_back((*look.own)[i]);
        look.own = std::make_shared<const std::vector<std::uint32_t>>(std::move(own));
    }
    look.points = std::make_shared<const std::vector<Eigen::Vector3f>>(keptPoints(*look.points, section));
}

} // namespace

void ShownScans::update(const Design& design, const DesignFiles& files, const Selection& selection,
                        const SceneVisibility& visibility)
{
    using Layer = SceneVisibility::Layer;
    m_points.update(design, files);
    m_scene.points.clear();
    if (!visibility.layerVisible(Layer::Scans) || m_scene.map)
        return;
    m_scene.points = m_points.looks(selection.elements(), m_scene.colors, visibility.hidden(),
                                    visibility.layerVisible(Layer::ScanColors));
    for (ViewScene::PointsLook& look : m_scene.points) {
        look.color.setAlphaF(look.color.alphaF() * static_cast<float>(m_opacity));
        if (m_scene.section)
            cutLook(look, *m_scene.section);
    }
}

void ShownScans::addPairs()
{
    const QColor red(0xd8, 0x2c, 0x20);
    for (const auto& [on, of] : m_pairs)
        m_scene.lines.push_back({{on.cast<float>(), of.cast<float>()}, red, 1.2F, 0.25F});
}

} // namespace bolster
