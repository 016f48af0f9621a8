#include "CoverNavigation.h"

#include "MeshShape.h"
#include "ShownScene.h"

#include <QWidget>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bolster {

CoverNavigation::CoverNavigation(const ShownScene& shown, const QWidget& view)
    : m_shown(shown)
    , m_view(view)
{
    m_flight.setDuration(260);
    m_flight.setEasingCurve(QEasingCurve::InOutCubic);
    m_flight.setStartValue(0.0);
    m_flight.setEndValue(1.0);
    connect(&m_flight, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        m_to.size = m_camera.size;
        apply(Camera::between(m_from, m_to, t.toDouble()));
    });
    connect(&shown, &ShownScene::boxChanged, this, &CoverNavigation::catchUp);
}

void CoverNavigation::resize()
{
    m_camera.size = {std::max(m_view.width(), 1), std::max(m_view.height(), 1)};
}

void CoverNavigation::apply(const Camera& camera)
{
    m_camera = camera;
    resize();
    emit moved(m_camera);
}

void CoverNavigation::stop()
{
    m_flight.stop();
    m_fitPending = false;
}

void CoverNavigation::setCamera(const Camera& camera)
{
    stop();
    const bool before = m_camera.perspective;
    apply(camera);
    if (before != m_camera.perspective)
        emit perspectiveChanged(m_camera.perspective);
}

void CoverNavigation::goTo(const Camera& camera)
{
    stop();
    m_from = m_camera;
    m_to = camera;
    if (m_view.isVisible() && m_animated)
        m_flight.start();
    else
        apply(camera);
}

void CoverNavigation::flyTo(const Camera& camera)
{
    Camera there = camera;
    there.size = m_camera.size;
    goTo(there);
    if (there.perspective != m_camera.perspective)
        setPerspective(there.perspective);
}

void CoverNavigation::returnTo(const Viewpoint& view)
{
    m_returned = true;
    m_seen = Box3();
    setCamera(Camera{view, m_camera.size});
}

/// Where the camera is, or where it is flying to: who wants another part of that must not keep what lies between.
Camera CoverNavigation::destination() const
{
    Camera camera = m_flight.state() == QAbstractAnimation::Running ? m_to : m_camera;
    camera.size = m_camera.size;
    return camera;
}

void CoverNavigation::setPerspective(bool perspective)
{
    Camera camera = destination();
    camera.perspective = perspective;
    setCamera(camera);
}

double CoverNavigation::frontSide() const
{
    const ViewScene& scene = m_shown.scene();
    if (scene.surface)
        return frontAzimuth(scene.surface->positions);
    return scene.frames.empty() ? 0 : frontAzimuth(placedPoints(scene.frames.front()));
}

void CoverNavigation::setStandardView(StandardView view, const Box3& with)
{
    m_returned = false;
    m_seen = Box3();
    Camera camera = destination();
    camera.look(view);
    if (view == StandardView::ThreeQuarter)
        camera.azimuth += frontSide();
    camera.fit(m_shown.scene().box.merged(with));
    goTo(camera);
}

void CoverNavigation::lookFrom(double azimuth, double elevation)
{
    Camera camera = m_camera;
    camera.azimuth = azimuth;
    camera.elevation = elevation;
    camera.fit(m_shown.scene().box);
    goTo(camera);
}

void CoverNavigation::fitAll()
{
    m_returned = false;
    if (!m_view.isVisible()) {
        m_fitPending = true;
        return;
    }
    Camera camera = destination();
    camera.fit(m_shown.boxWithScans());
    goTo(camera);
}

void CoverNavigation::fitSelection()
{
    const Box3 box = m_shown.selectedBox();
    if (box.isEmpty()) {
        fitAll();
        return;
    }
    fit(box);
}

void CoverNavigation::fit(const Box3& box)
{
    Camera camera = m_camera;
    camera.fit(box);
    goTo(camera);
}

void CoverNavigation::catchUp()
{
    const Box3& box = m_shown.scene().box;
    if (m_shown.empty()) {
        m_fitPending = !m_returned;
    } else if (m_fitPending && m_view.width() > 1 && m_view.isVisible()) {
        m_fitPending = false;
        if (!comesBack(box)) {
            m_camera.look(StandardView::ThreeQuarter);
            m_camera.azimuth += frontSide();
            m_camera.fit(box);
        }
    }
    if (!m_shown.empty())
        m_seen.extend(box);
}

/// All was deleted, and some of that is there again: who undoes wants to see it from where it was seen.
bool CoverNavigation::comesBack(const Box3& box) const
{
    constexpr double notTiny = 0.2; // of what was there
    return !m_seen.isEmpty() && m_seen.contains(box) && box.diagonal().norm() > notTiny * m_seen.diagonal().norm();
}

bool CoverNavigation::inPicture(const Box3& box) const
{
    for (int corner = 0; corner < 8; ++corner) {
        const auto pixel = m_camera.pixel(box.corner(static_cast<Box3::CornerType>(corner)));
        if (!pixel || !m_view.rect().contains(static_cast<int>(pixel->x()), static_cast<int>(pixel->y())))
            return false;
    }
    return true;
}

bool CoverNavigation::isInView(const Camera& camera, const Vec3& place) const
{
    const std::optional<Vec2> pixel = camera.pixel(place);
    return pixel && QRectF(m_view.rect()).contains(pixel->x(), pixel->y());
}

bool CoverNavigation::sees(const Camera& camera, const Vec3& place) const
{
    if (!isInView(camera, place))
        return false;
    constexpr double near = 5; // mm: the pixel may be that of what lies beside it
    const Vec2 pixel = *camera.pixel(place);
    const CoverHit hit = m_shown.hits().hitSolid(camera, {pixel.x(), pixel.y()});
    return !hit || camera.depth(hit.position) > camera.depth(place) - near;
}

void CoverNavigation::reveal(const Vec3& place)
{
    if (isInView(m_camera, place))
        return;
    Camera camera = m_camera;
    camera.target = place;
    goTo(camera);
}

void CoverNavigation::face(const Vec3& place, const Vec3& outwards)
{
    constexpr double slanted = 0.2; // cosine, at least
    const auto isFaced = [&](const Camera& camera) { return camera.backward().dot(outwards) > slanted; };
    if (sees(m_camera, place) && isFaced(m_camera))
        return;
    constexpr double step = std::numbers::pi / 12;
    Camera best = m_camera;
    double most = -std::numeric_limits<double>::infinity();
    for (int around = 0; around < 24; ++around)
        for (int up = 0; up <= 5; ++up) {
            Camera turned = m_camera;
            turned.orbit(around * step, up * step - m_camera.elevation, middle());
            if (!isInView(turned, place))
                turned.target = place;
            // What is seen at all, then from outside, then with the least turning.
            const double worth =
                4 * sees(turned, place) + 2 * isFaced(turned) + m_camera.backward().dot(turned.backward());
            if (worth > most) {
                most = worth;
                best = turned;
            }
        }
    goTo(best);
}

Vec3 CoverNavigation::middle() const
{
    const Box3& box = m_shown.scene().box;
    return box.isEmpty() ? m_camera.target : Vec3(box.center());
}

Vec3 CoverNavigation::anchorAt(QPointF pixel) const
{
    if (const CoverHit solid = m_shown.hits().hitSolid(m_camera, pixel))
        return solid.position;
    const bool inFront = !m_camera.perspective || m_camera.depth(middle()) > 0;
    return m_camera.onPlaneThrough(inFront ? middle() : m_camera.target, {pixel.x(), pixel.y()});
}

void CoverNavigation::turn(double azimuthBy, double elevationBy)
{
    Camera camera = m_camera;
    camera.orbit(azimuthBy, elevationBy, middle());
    setCamera(camera);
}

void CoverNavigation::pan(QPointF by, QPointF pixel)
{
    Camera camera = m_camera;
    camera.pan({by.x(), by.y()}, anchorAt(pixel));
    setCamera(camera);
}

double CoverNavigation::closer(double notches)
{
    constexpr double wheelStep = 0.88; // distance after one notch
    return std::pow(wheelStep, notches);
}

void CoverNavigation::zoom(double factor, QPointF pixel)
{
    Camera camera = m_camera;
    camera.zoom(factor, anchorAt(pixel));
    setCamera(camera);
}

} // namespace bolster
