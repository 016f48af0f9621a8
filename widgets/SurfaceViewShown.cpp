// What of the scene the 3D view shows: hidden elements, what the section cuts, what is see-through, the other
// view's pointer.
#include "Crosshair.h"
#include "Document.h"
#include "Hiding.h"
#include "SelectionEdits.h"
#include "SurfaceView.h"

namespace bolster {

namespace {

constexpr double usualFrameOpacity = 0.45;
constexpr double nearlyThere = 3; // mm: what is so near hides nothing

} // namespace

void SurfaceView::setHidden(std::set<ElementId> hidden)
{
    if (hidden == m_hidden)
        return;
    m_hidden = std::move(hidden);
    updateCurves();
    updateFrames();
    updateScans();
    setSurface(m_surface);
    emit hiddenChanged();
}

/// Hidden ones, what is drawn in them, and what no layer shows.
std::set<ElementId> SurfaceView::unseen() const
{
    const Design& design = m_document.design();
    std::set<ElementId> result = m_hidden;
    for (const auto& [id, element] : design.elements()) {
        const bool off =
            (std::holds_alternative<FixationCurve>(*element) && !layerVisible(Layer::FixationCurves)) ||
            (std::holds_alternative<HandleCurve>(*element) && !layerVisible(Layer::HandleCurves)) ||
            (std::holds_alternative<FancySeam>(*element) && !layerVisible(Layer::FancySeams));
        if (off || bolster::isHidden(design, m_hidden, id))
            result.insert(id);
    }
    return result;
}

void SurfaceView::updateCurves()
{
    m_curves.update(m_document.design(), unseen());
}

void SurfaceView::updateMirrored()
{
    m_mirrored =
        layerVisible(Layer::Twins) ? mirroredOfMarked(m_document.design(), m_selection) : std::set<ElementId>();
}

void SurfaceView::updateCover()
{
    m_scene.surface = layerVisible(Layer::Cover) ? m_visibleCover.of(m_surface, unseen()) : nullptr;
    m_scene.cover = m_scene.surface && m_cover && m_cover->surface == m_surface ? m_cover : nullptr;
    m_scene.trims = m_scene.cover ? m_trims : nullptr;
    m_hitTest.setSurface(m_scene.surface);
    m_places.setSurface(m_scene.surface);
}

void SurfaceView::setFrameOpacity(double opacity)
{
    m_scene.frameOpacity = opacity / usualFrameOpacity;
    draw(true);
}

void SurfaceView::setScanOpacity(double opacity)
{
    m_scanOpacity = opacity;
    updateScans();
    draw(true);
}

void SurfaceView::cutMarks()
{
    if (!m_scene.section)
        return;
    const SectionPlane& section = *m_scene.section;
    std::vector<SurfaceLine> lines;
    for (const SurfaceLine& line : m_scene.lines)
        for (std::vector<Eigen::Vector3f>& part : keptParts(line.points, section)) {
            lines.push_back(line);
            lines.back().points = std::move(part);
        }
    m_scene.lines = std::move(lines);
    std::erase_if(m_scene.dots, [&](const SurfaceDot& dot) { return !section.keeps(dot.at.cast<double>()); });
}

void SurfaceView::cutPoints()
{
    for (SurfaceScene::PointsLook& look : m_scene.points) {
        look.color.setAlphaF(look.color.alphaF() * static_cast<float>(m_scanOpacity));
        if (m_scene.section)
            look.points =
                std::make_shared<const std::vector<Eigen::Vector3f>>(keptPoints(*look.points, *m_scene.section));
    }
}

std::optional<CoverPoint> SurfaceView::coverPointOf(const SurfaceHit& solid) const
{
    return solid.kind == SurfaceHit::Kind::Cover ? m_places.inPattern(solid.triangle, solid.position)
                                                 : std::nullopt;
}

void SurfaceView::showPlace(const std::optional<CoverPoint>& point)
{
    m_shown = point;
    m_place = point ? m_places.onCover(*point) : std::nullopt;
    placeCrosshair();
}

void SurfaceView::placeCrosshair()
{
    const bool cutAway = m_place && m_scene.section && !m_scene.section->keeps(*m_place);
    const std::optional<Vec2> pixel = m_place && !cutAway ? m_camera.pixel(*m_place) : std::nullopt;
    if (!pixel) {
        m_crosshair->showAt(std::nullopt);
        return;
    }
    const SurfaceHit front = m_hitTest.hitSolid(m_camera, {pixel->x(), pixel->y()});
    const bool behind = front && m_camera.depth(front.position) < m_camera.depth(*m_place) - nearlyThere;
    m_crosshair->showAt(QPointF(pixel->x(), pixel->y()), behind);
}

void SurfaceView::flyTo(const Camera& camera)
{
    Camera there = camera;
    there.size = m_camera.size;
    goTo(there);
    if (there.perspective != m_camera.perspective)
        setPerspective(there.perspective);
}

void SurfaceView::reveal(const CoverPoint& point)
{
    const std::optional<Vec3> place = m_places.onCover(point);
    if (!place)
        return;
    const std::optional<Vec2> pixel = m_camera.pixel(*place);
    if (pixel && QRectF(rect()).contains(pixel->x(), pixel->y()))
        return;
    Camera camera = m_camera;
    camera.target = *place;
    goTo(camera);
}

} // namespace bolster
