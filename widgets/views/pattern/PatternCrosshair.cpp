#include "PatternCrosshair.h"

#include "Crosshair.h"
#include "PatternNavigation.h"
#include "ShownPattern.h"

namespace bolster {

PatternCrosshair::PatternCrosshair(const ShownPattern& shown, const PatternNavigation& navigation, QWidget& view)
    : m_shown(shown)
    , m_navigation(navigation)
    , m_crosshair(new Crosshair(&view))
{}

void PatternCrosshair::show(const std::optional<CoverPoint>& point)
{
    m_point = point;
    place();
}

void PatternCrosshair::place()
{
    const std::optional<Vec2> at = m_point ? m_shown.placeOf(*m_point) : std::nullopt;
    m_crosshair->showAt(at ? std::optional(m_navigation.transform().toPixels(*at)) : std::nullopt);
}

} // namespace bolster
