#include "Camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster {
namespace {

Camera someCamera(bool perspective)
{
    Camera camera;
    camera.target = {100, -50, 300};
    camera.azimuth = 0.4;
    camera.elevation = 0.6;
    camera.size = {800, 600};
    camera.perspective = perspective;
    return camera;
}

class CameraTest : public testing::TestWithParam<bool> {
protected:
    Camera camera = someCamera(GetParam());
    const Vec3 point{250, 120, 400};
};

TEST_P(CameraTest, RaysGoThroughTheirPixels)
{
    const Vec2 pixel(620, 130);
    const Camera::Ray ray = camera.ray(pixel);
    const std::optional<Vec2> back = camera.pixel(ray.origin + 3 * camera.distance * ray.direction);
    if (GetParam()) {
        ASSERT_TRUE(back);
        EXPECT_LT((*back - pixel).norm(), 1e-6);
    }
    const Vec3 at = camera.onPlaneThrough(point, pixel);
    EXPECT_LT((*camera.pixel(at) - pixel).norm(), 1e-6);
    EXPECT_NEAR(camera.depth(at), camera.depth(point), 1e-6);
}

TEST_P(CameraTest, MatricesAgreeWithPixels)
{
    const Box3 box(Vec3(-500, -500, 0), Vec3(500, 500, 900));
    const Eigen::Vector4d clip = camera.projectionMatrix(box) * camera.viewMatrix() * point.homogeneous();
    const Vec3 shown = clip.head<3>() / clip.w();
    const Vec2 pixel = *camera.pixel(point);
    EXPECT_NEAR((shown.x() + 1) * 400, pixel.x(), 1e-6);
    EXPECT_NEAR((1 - shown.y()) * 300, pixel.y(), 1e-6);
    EXPECT_GT(shown.z(), -1);
    EXPECT_LT(shown.z(), 1);
}

TEST_P(CameraTest, TurningKeepsThePivotInItsPlace)
{
    const Vec2 before = *camera.pixel(point);
    camera.orbit(0.7, -0.3, point);
    EXPECT_LT((*camera.pixel(point) - before).norm(), 1e-6);
}

TEST_P(CameraTest, NeverTurnsUpsideDown)
{
    camera.orbit(0, 100, point);
    EXPECT_NEAR(camera.elevation, std::numbers::pi / 2, 1e-12);
    EXPECT_GE(camera.upward().z(), -1e-12);
    camera.orbit(0, -100, point);
    EXPECT_NEAR(camera.elevation, -std::numbers::pi / 2, 1e-12);
    EXPECT_GE(camera.upward().z(), -1e-12);
}

TEST_P(CameraTest, PanningFollowsThePointer)
{
    const Vec2 before = *camera.pixel(point);
    camera.pan({30, -12}, point);
    EXPECT_LT((*camera.pixel(point) - before - Vec2(30, -12)).norm(), 1e-6);
}

TEST_P(CameraTest, ZoomingKeepsTheAnchorInItsPlace)
{
    const Vec2 before = *camera.pixel(point);
    const double size = camera.pixelSize(point);
    camera.zoom(0.5, point);
    EXPECT_LT((*camera.pixel(point) - before).norm(), 1e-6);
    EXPECT_NEAR(camera.pixelSize(point), size / 2, 1e-9);
    for (int i = 0; i < 200; ++i)
        camera.zoom(0.5, point);
    EXPECT_GE(camera.distance, 1);
}

TEST_P(CameraTest, FitsBoxesTightly)
{
    const Box3 box(Vec3(-400, 100, 30), Vec3(500, 700, 1200));
    for (const Vec2& size : {Vec2(800, 600), Vec2(300, 900)}) {
        camera.size = size;
        camera.fit(box);
        double widest = 0;
        for (int i = 0; i < 8; ++i) {
            const Vec2 pixel = *camera.pixel(box.corner(static_cast<Box3::CornerType>(i)));
            widest = std::max(widest, ((pixel - size / 2).cwiseQuotient(size / 2)).cwiseAbs().maxCoeff());
        }
        EXPECT_LT(widest, 1);
        EXPECT_GT(widest, 0.8);
    }
    const Camera before = camera;
    camera.fit({});
    EXPECT_EQ(camera, before);
}

INSTANTIATE_TEST_SUITE_P(Both, CameraTest, testing::Bool(),
                         [](const auto& one) { return one.param ? "Perspective" : "Orthographic"; });

TEST(Camera, StandardViewsLookAlongTheAxes)
{
    Camera camera;
    camera.look(Camera::StandardView::Front);
    EXPECT_TRUE(camera.backward().isApprox(Vec3(0, -1, 0)));
    EXPECT_TRUE(camera.rightward().isApprox(Vec3(1, 0, 0)));
    camera.look(Camera::StandardView::Right);
    EXPECT_TRUE(camera.backward().isApprox(Vec3(1, 0, 0)));
    camera.look(Camera::StandardView::Back);
    EXPECT_TRUE(camera.backward().isApprox(Vec3(0, 1, 0)));
    camera.look(Camera::StandardView::Left);
    EXPECT_TRUE(camera.backward().isApprox(Vec3(-1, 0, 0)));
    camera.look(Camera::StandardView::Top);
    EXPECT_TRUE(camera.backward().isApprox(Vec3(0, 0, 1)));
    EXPECT_TRUE(camera.upward().isApprox(Vec3(0, 1, 0)));
}

TEST(Camera, FlightsTakeTheShorterTurn)
{
    Camera a, b;
    a.azimuth = 3;
    b.azimuth = -3;
    const Camera middle = Camera::between(a, b, 0.5);
    EXPECT_NEAR(std::abs(std::remainder(middle.azimuth - std::numbers::pi, 2 * std::numbers::pi)), 0, 1e-9);
    EXPECT_EQ(Camera::between(a, b, 1), b);
}

TEST(Camera, PointsBehindTheEyeHaveNoPixel)
{
    Camera camera;
    camera.size = {100, 100};
    EXPECT_FALSE(camera.pixel(camera.eye() + 10 * camera.backward()));
    camera.perspective = false;
    EXPECT_TRUE(camera.pixel(camera.eye() + 10 * camera.backward()));
}

} // namespace
} // namespace bolster
