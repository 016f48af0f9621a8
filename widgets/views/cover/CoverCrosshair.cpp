#include "CoverCrosshair.h"

#include "Crosshair.h"
#include "ShownScene.h"

namespace bolster {

namespace {

constexpr double nearlyThere = 3; // mm: what is so near hides nothing

} // namespace

CoverCrosshair::CoverCrosshair(ShownScene& shown, const Camera& camera, QWidget& view)
    : m_shown(shown)
    , m_camera(camera)
    , m_crosshair(new Crosshair(&view))
{}

void CoverCrosshair::show(const std::optional<CoverPoint>& point)
{
    m_point = point;
    m_place = point ? m_shown.onCover(*point) : std::nullopt;
    place();
}

void CoverCrosshair::place()
{
    const std::optional<SectionPlane>& section = m_shown.scene().section;
    const bool cutAway = m_place && section && !section->keeps(*m_place);
    const std::optional<Vec2> pixel = m_place && !cutAway ? m_camera.pixel(*m_place) : std::nullopt;
    if (!pixel) {
        m_crosshair->showAt(std::nullopt);
        return;
    }
    const CoverHit front = m_shown.hits().hitSolid(m_camera, {pixel->x(), pixel->y()});
    const bool behind = front && m_camera.depth(front.position) < m_camera.depth(*m_place) - nearlyThere;
    m_crosshair->showAt(QPointF(pixel->x(), pixel->y()), behind);
}

} // namespace bolster
