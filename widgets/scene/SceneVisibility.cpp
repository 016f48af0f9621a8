#include "SceneVisibility.h"

#include "Hiding.h"

#include <utility>

namespace bolster {

void SceneVisibility::setLayerVisible(Layer layer, bool visible)
{
    if (visible == layerVisible(layer))
        return;
    if (visible)
        m_layers.insert(layer);
    else
        m_layers.erase(layer);
    emit changed();
}

void SceneVisibility::setHidden(std::set<ElementId> hidden)
{
    if (hidden == m_hidden)
        return;
    m_hidden = std::move(hidden);
    emit changed();
    emit hiddenChanged();
}

std::set<ElementId> SceneVisibility::unseen(const Design& design) const
{
    std::set<ElementId> result = m_hidden;
    for (const auto& [id, element] : design.elements()) {
        const bool off =
            (std::holds_alternative<FixationCurve>(*element) && !layerVisible(Layer::FixationCurves)) ||
            (std::holds_alternative<HandleCurve>(*element) && !layerVisible(Layer::HandleCurves)) ||
            (std::holds_alternative<FancySeam>(*element) && !layerVisible(Layer::FancySeams));
        if (off || isHidden(design, m_hidden, id))
            result.insert(id);
    }
    return result;
}

} // namespace bolster
