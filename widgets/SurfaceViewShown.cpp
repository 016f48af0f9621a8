// What of the scene the 3D view shows: hidden elements, what the section cuts, what is see-through, the other
// view's pointer.
#include "Crosshair.h"
#include "Document.h"
#include "FramePieces.h"
#include "Hiding.h"
#include "SelectionEdits.h"
#include "SurfaceView.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr double nearlyThere = 3; // mm: what is so near hides nothing

void cutLook(SurfaceScene::PointsLook& look, const SectionPlane& section)
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

void SurfaceView::showFramePieces(ElementId frame, const std::vector<int>& pieces)
{
    if (m_pieceFrame == frame && m_pieces == pieces)
        return;
    m_pieceFrame = frame;
    m_pieces = pieces;
    updateMarks();
    draw(false);
}

void SurfaceView::addFramePieces()
{
    const auto* frame = m_document.design().find<Frame>(m_pieceFrame);
    const auto file = m_files.meshes.find(m_pieceFrame);
    if (!frame || file == m_files.meshes.end() || !file->second)
        return;
    const std::vector<FramePiece>& pieces = piecesOf(file->second)->pieces;
    Box3 box;
    for (const int piece : m_pieces)
        if (piece >= 0 && piece < std::ssize(pieces))
            box.extend(pieces[static_cast<std::size_t>(piece)].box);
    if (box.isEmpty())
        return;
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
            const int other = corner | 1 << axis;
            if (other == corner)
                continue;
            const auto at = [&](int k) {
                const auto place = static_cast<Box3::CornerType>(k);
                return Eigen::Vector3f(frame->placed(box.corner(place)).cast<float>());
            };
            m_scene.lines.push_back({{at(corner), at(other)}, m_scene.colors.accent, 2, 0.9F, 0.8F});
        }
}

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
    m_scene.trims = m_scene.cover ? visibleTrims(m_trims, unseen()) : nullptr;
    m_hitTest.setSurface(m_scene.surface);
    m_places.setSurface(m_scene.surface);
    useSkins();
}

SurfaceView::Skins SurfaceView::skinsOf(const Skins& wanted, std::stop_token stop)
{
    Skins made = wanted;
    const FrameSkins pressed(wanted.surface.get());
    for (std::size_t f = 0; f < made.frames.size() && !stop.stop_requested(); ++f)
        if (made.frames[f].mesh)
            made.frames[f].skin = pressed.skin(*made.frames[f].mesh, made.frames[f].placement, stop);
    return made;
}

void SurfaceView::requestSkins()
{
    if (m_skinsFit)
        return;
    Skins wanted{m_scene.surface, m_scene.frames, m_frameIds};
    for (Scene::FrameLook& frame : wanted.frames)
        frame.skin = nullptr;
    m_skinJob.request(std::move(wanted), true);
}

/// Besides these, those under the whole cover are kept: it comes back when nothing of it is hidden any more.
void SurfaceView::takeSkins(const Skins& made)
{
    for (std::size_t f = 0; f < made.frames.size(); ++f) {
        const Scene::FrameLook& frame = made.frames[f];
        std::vector<MadeSkin>& known = m_skins[made.ids[f]];
        std::erase_if(known, [&](const MadeSkin& other) {
            return other.mesh != frame.mesh || other.cover == made.surface || other.cover != m_surface;
        });
        if (frame.skin)
            known.insert(known.begin(), {frame.mesh, made.surface, frame.skin});
    }
    useSkins();
    draw(false);
}

/// The one that was made under what is shown of the cover, with the frame where it is; else the newest.
const SurfaceView::MadeSkin* SurfaceView::skinOf(std::size_t frame) const
{
    const auto found = m_skins.find(m_frameIds[frame]);
    if (found == m_skins.end())
        return nullptr;
    const Scene::FrameLook& look = m_scene.frames[frame];
    const MadeSkin* newest = nullptr;
    for (const MadeSkin& made : found->second) {
        if (made.mesh != look.mesh)
            continue;
        if (made.cover == m_scene.surface && made.skin->placement == look.placement)
            return &made;
        newest = newest ? newest : &made;
    }
    return newest;
}

/// Of frames that were hidden, have moved or changed their colour the skin is kept until there is a better one.
void SurfaceView::useSkins()
{
    m_scene.skinned = m_scene.surface;
    m_skinsFit = true;
    bool any = false;
    for (std::size_t f = 0; f < m_scene.frames.size(); ++f) {
        const MadeSkin* made = skinOf(f);
        m_scene.frames[f].skin = made ? made->skin : nullptr;
        m_skinsFit = m_skinsFit && made && made->cover == m_scene.surface &&
                     made->skin->placement == m_scene.frames[f].placement;
        if (!made)
            continue;
        any = true;
        if (made->cover != m_scene.surface)
            m_scene.skinned = made->cover;
    }
    if (!any)
        m_scene.skinned = nullptr;
}

void SurfaceView::keepSkins()
{
    std::erase_if(m_skins, [this](const auto& known) { return !m_document.design().element(known.first); });
    useSkins();
    if (std::ranges::find(m_scene.frames, FrameSkinPtr(), &Scene::FrameLook::skin) != m_scene.frames.end())
        requestSkins();
}

void SurfaceView::setFrameOpacity(double opacity)
{
    m_scene.frameOpacity = opacity;
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
            cutLook(look, *m_scene.section);
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
