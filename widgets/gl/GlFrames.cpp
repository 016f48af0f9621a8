#include "GlFrames.h"

#include "FewerTriangles.h"

#include <algorithm>
#include <iterator>

namespace bolster {

namespace {

/// mm by which frames are drawn farther away while it is not known how the cover lies on them now, or at all.
constexpr float whileCoverMoves = 30, beforeFirstSkin = 120;
constexpr float stepsBehindCover = 40; ///< of depth; more than the patches of a cover have between them

/// From where the skin was made to where the frame is now.
Eigen::Matrix4f movedSince(const Placement& then, const Placement& now)
{
    Eigen::Matrix4d moved = Eigen::Matrix4d::Identity();
    const Eigen::Matrix3d turn = (now.rotation * then.rotation.conjugate()).toRotationMatrix();
    moved.topLeftCorner<3, 3>() = now.scale / then.scale * turn;
    moved.topRightCorner<3, 1>() = now.position - moved.topLeftCorner<3, 3>() * then.position;
    return moved.cast<float>();
}

} // namespace

GlFrames::Skins::Skins(GlFunctions& gl)
{
    array.create();
    const QOpenGLVertexArrayObject::Binder bound(&array);
    bindColumns(gl, corners, sizeof(FrameSkin::Corner),
                {{0, 3, GL_FLOAT, offsetof(FrameSkin::Corner, position)},
                 {1, 3, GL_FLOAT, offsetof(FrameSkin::Corner, normal)},
                 {2, 3, GL_FLOAT, offsetof(FrameSkin::Corner, grain)}});
}

void GlFrames::Skins::put(const std::vector<FrameSkinPtr>& skins, const CornersOf& cornersOf)
{
    firstOf = {0};
    std::vector<FrameSkin::Corner> all;
    for (const FrameSkinPtr& skin : skins) {
        if (skin)
            std::ranges::copy(cornersOf(*skin), std::back_inserter(all));
        firstOf.push_back(all.size());
    }
    corners.put(all, QOpenGLBuffer::StaticDraw);
}

GlFrames::GlFrames(GlFunctions& gl)
    : m_gl(gl)
    , m_program("frame.vert", "frame.frag")
    , m_all(gl)
    , m_fewer(gl)
{}

void GlFrames::update(const ViewScene& scene)
{
    std::vector<FrameSkinPtr> skins;
    for (const Scene::FrameLook& frame : scene.frames)
        skins.push_back(frame.skin);
    if (m_skins == skins)
        return;
    m_skins = std::move(skins);
    m_all.put(m_skins, [](const FrameSkin& skin) { return std::span(skin.corners); });
    m_fewer.firstOf.clear();
}

/// Once, when something moves.
void GlFrames::putFewer()
{
    if (!m_fewer.firstOf.empty())
        return;
    const double share = static_cast<double>(mostMovingTriangles) / static_cast<double>(triangles());
    std::vector<FrameSkin::Corner> fewer; // of the skin that is being put
    m_fewer.put(m_skins, [&](const FrameSkin& skin) {
        fewer = fewerCorners(skin.corners,
                             static_cast<std::size_t>(share * static_cast<double>(skin.corners.size()) / 3));
        return std::span<const FrameSkin::Corner>(fewer);
    });
}

std::size_t GlFrames::triangles() const
{
    return m_all.firstOf.empty() ? 0 : m_all.firstOf.back() / 3;
}

GlFrames::Part GlFrames::partOf(const ViewScene& scene, std::size_t frame)
{
    const bool solid = !scene.surface || scene.frames[frame].opacity * scene.frameOpacity >= 1;
    return solid ? Part::Solid : Part::SeeThrough;
}

bool GlFrames::has(const ViewScene& scene, Part part) const
{
    for (std::size_t f = 0; f < std::min(m_skins.size(), scene.frames.size()); ++f)
        if (m_skins[f] && partOf(scene, f) == part)
            return true;
    return false;
}

void GlFrames::drawAll(const ViewScene& scene, Part part, Skins& skins)
{
    const QOpenGLVertexArrayObject::Binder bound(&skins.array);
    for (std::size_t f = 0; f < std::min(m_skins.size(), scene.frames.size()); ++f) {
        if (!m_skins[f] || partOf(scene, f) != part)
            continue;
        const Scene::FrameLook& frame = scene.frames[f];
        m_program.set("moved", movedSince(m_skins[f]->placement, frame.placement));
        m_program.set("material", linearLight(colorOf(colorShown(frame.material))));
        m_program.set("kind", static_cast<int>(frame.material.kind));
        m_program.set("opacity",
                      part == Part::Solid ? 1.F : static_cast<float>(frame.opacity * scene.frameOpacity));
        m_gl.glDrawArrays(GL_TRIANGLES, static_cast<GLint>(skins.firstOf[f]),
                          static_cast<GLsizei>(skins.firstOf[f + 1] - skins.firstOf[f]));
    }
}

void GlFrames::draw(const ViewScene& scene, const GlView& view, Part part, bool quick)
{
    if (!has(scene, part))
        return;
    const bool fewer = quick && tooManyToMove(triangles());
    if (fewer)
        putFewer();
    Skins& skins = fewer ? m_fewer : m_all;
    m_program.use();
    view.setTransforms(m_program);
    view.setLights(m_program);
    const bool known = !scene.surface || scene.skinned == scene.surface;
    m_program.set("push", known ? 0.F : scene.skinned ? whileCoverMoves : beforeFirstSkin);
    // The cover lies some pixels' slope behind its lines, which from far away is more than it lies above the frame.
    m_gl.glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl.glPolygonOffset(2, stepsBehindCover);
    if (part == Part::SeeThrough) { // first how near it is, then its looks there
        m_gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        drawAll(scene, part, skins);
        m_gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        m_gl.glEnable(GL_BLEND);
    }
    drawAll(scene, part, skins);
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
}

} // namespace bolster
