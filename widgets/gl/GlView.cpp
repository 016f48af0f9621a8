#include "GlView.h"

#include "Shading.h"

#include <cmath>

namespace bolster {

namespace {

/// A direction given relative to where the camera looks from, in eye coordinates: the lights turn with the viewer.
Eigen::Vector3f lightDirection(const Camera& camera, double azimuthBy, double elevation)
{
    const double azimuth = camera.azimuth + azimuthBy;
    const Vec3 world(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                     std::sin(elevation));
    return (camera.viewMatrix().topLeftCorner<3, 3>() * world).cast<float>();
}

/// With room for the ground around the scene.
Box3 drawnBox(const ViewScene& scene)
{
    Box3 box = scene.box;
    if (!box.isEmpty() && scene.ground) {
        const Vec3 around(box.diagonal().norm(), box.diagonal().norm(), 0);
        box = Box3(Vec3(box.min() - around), Vec3(box.max() + around));
        box.extend(Vec3(box.center().x(), box.center().y(), scene.floor));
    }
    return box;
}

} // namespace

GlView::GlView(const ViewScene& scene, const Camera& camera, const QSize& size, const Vec2& jitter)
    : viewport(static_cast<float>(size.width()), static_cast<float>(size.height()))
    , perspective(camera.perspective)
    , key(lightDirection(camera, shading::keyAzimuth, shading::keyElevation))
    , rim(lightDirection(camera, shading::rimAzimuth, shading::rimElevation))
    , up(camera.viewMatrix().topLeftCorner<3, 3>().col(2).cast<float>())
{
    Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
    shift(0, 3) = 2 * jitter.x() / size.width();
    shift(1, 3) = 2 * jitter.y() / size.height();
    if (scene.section)
        section << scene.section->normal.cast<float>(), static_cast<float>(scene.section->offset);
    view = camera.viewMatrix().cast<float>();
    projection = (shift * camera.projectionMatrix(drawnBox(scene))).cast<float>();
    pixelRatio = viewport.y() / static_cast<float>(std::max(camera.size.y(), 1.0));
    const double step = 2 * std::tan(camera.fieldOfView / 2) / size.height();
    pixelAtOne = static_cast<float>(perspective ? step : step * camera.distance);
}

void GlView::setTransforms(GlProgram& program) const
{
    program.set("view", view);
    program.set("projection", projection);
    program.set("section", section);
}

void GlView::setLights(GlProgram& program) const
{
    program.set("keyDirection", key);
    program.set("rimDirection", rim);
    program.set("upDirection", up);
    program.set("perspectiveView", perspective);
}

void GlView::setPixels(GlProgram& program) const
{
    program.set("viewport", viewport);
    program.set("pixelRatio", pixelRatio);
    program.set("pixelAtOne", pixelAtOne);
    program.set("perspectiveView", perspective);
}

} // namespace bolster
