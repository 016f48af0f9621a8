#include "Camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double nearest = 1;    ///< mm
constexpr double farthest = 1e8; ///< mm
constexpr double frameMargin = 1.12;

double wrappedAngle(double angle)
{
    return std::remainder(angle, 2 * pi);
}

std::array<Vec3, 8> corners(const Box3& box)
{
    std::array<Vec3, 8> result;
    for (int i = 0; i < 8; ++i)
        result[static_cast<std::size_t>(i)] = box.corner(static_cast<Box3::CornerType>(i));
    return result;
}

} // namespace

Vec3 Camera::backward() const
{
    return {std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
}

Vec3 Camera::rightward() const
{
    return {std::cos(azimuth), std::sin(azimuth), 0};
}

Vec3 Camera::upward() const
{
    return backward().cross(rightward());
}

double Camera::pixelSize(const Vec3& at) const
{
    const double away = perspective ? std::max(depth(at), nearest * 1e-3) : distance;
    return 2 * std::tan(fieldOfView / 2) * away / std::max(size.y(), 1.0);
}

Eigen::Matrix4d Camera::viewMatrix() const
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.row(0).head<3>() = rightward();
    matrix.row(1).head<3>() = upward();
    matrix.row(2).head<3>() = backward();
    matrix.topRightCorner<3, 1>() = -matrix.topLeftCorner<3, 3>() * eye();
    return matrix;
}

Eigen::Matrix4d Camera::projectionMatrix(const Box3& box) const
{
    double front = distance, back = distance;
    if (!box.isEmpty())
        for (const Vec3& corner : corners(box)) {
            front = std::min(front, depth(corner));
            back = std::max(back, depth(corner));
        }
    const double margin = 0.05 * (back - front) + 1;
    front -= margin;
    back += margin;
    const double up = std::tan(fieldOfView / 2);
    const double right = up * size.x() / std::max(size.y(), 1.0);
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    if (perspective) {
        back = std::max(back, 2 * nearest);
        front = std::max(front, back * 1e-3); // for the depth buffer's sake
        matrix(0, 0) = 1 / right;
        matrix(1, 1) = 1 / up;
        matrix(2, 2) = -(back + front) / (back - front);
        matrix(2, 3) = -2 * back * front / (back - front);
        matrix(3, 2) = -1;
    } else {
        matrix(0, 0) = 1 / (right * distance);
        matrix(1, 1) = 1 / (up * distance);
        matrix(2, 2) = -2 / (back - front);
        matrix(2, 3) = -(back + front) / (back - front);
        matrix(3, 3) = 1;
    }
    return matrix;
}

std::optional<Vec2> Camera::pixel(const Vec3& point) const
{
    const double away = depth(point);
    if (perspective && away < nearest * 1e-3)
        return std::nullopt;
    const Vec3 fromEye = point - eye();
    const double scale = 1 / pixelSize(point);
    return Vec2(size.x() / 2 + scale * fromEye.dot(rightward()), size.y() / 2 - scale * fromEye.dot(upward()));
}

Camera::Ray Camera::ray(const Vec2& at) const
{
    const double step = 2 * std::tan(fieldOfView / 2) / std::max(size.y(), 1.0);
    const Vec3 across = step * ((at.x() - size.x() / 2) * rightward() + (size.y() / 2 - at.y()) * upward());
    if (perspective)
        return {eye(), (across - backward()).normalized()};
    // Parallel rays start far behind the eye, which may stand inside the scene.
    return {eye() + distance * across + 100 * distance * backward(), -backward()};
}

Vec3 Camera::onPlaneThrough(const Vec3& anchor, const Vec2& at) const
{
    const Ray from = ray(at);
    const double along = (anchor - from.origin).dot(backward()) / from.direction.dot(backward());
    return from.origin + along * from.direction;
}

void Camera::orbit(double azimuthBy, double elevationBy, const Vec3& pivot)
{
    Eigen::Matrix3d before, after;
    before << rightward(), upward(), backward();
    azimuth = wrappedAngle(azimuth + azimuthBy);
    elevation = std::clamp(elevation + elevationBy, -pi / 2, pi / 2);
    after << rightward(), upward(), backward();
    target = pivot + after * before.transpose() * (target - pivot);
}

void Camera::pan(const Vec2& pixels, const Vec3& anchor)
{
    const double step = pixelSize(anchor);
    target += step * (pixels.y() * upward() - pixels.x() * rightward());
}

void Camera::zoom(double factor, const Vec3& anchor)
{
    const double wanted = std::clamp(distance * factor, nearest, farthest);
    target = anchor + wanted / distance * (target - anchor);
    distance = wanted;
}

void Camera::fit(const Box3& box)
{
    if (box.isEmpty())
        return;
    const double tangentUp = std::tan(fieldOfView / 2) / frameMargin;
    const Vec2 tangent(tangentUp * std::max(size.x(), 1.0) / std::max(size.y(), 1.0), tangentUp);
    Eigen::Matrix3d basis;
    basis << rightward(), upward(), backward();
    target = box.center();
    // The corners seen farthest out to each side say where the middle is and how far away the eye must be; both
    // depend on each other in perspective, so a few rounds.
    for (int round = 0; round < 8; ++round) {
        Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
        for (const Vec3& corner : corners(box)) {
            const Vec3 p = basis.transpose() * (corner - target);
            const Vec2 nearer = perspective ? Vec2(tangent * p.z()) : Vec2(Vec2::Zero());
            high = high.cwiseMax(p.head<2>() + nearer);
            low = low.cwiseMin(p.head<2>() - nearer);
        }
        distance = std::clamp(((high - low) / 2).cwiseQuotient(tangent).maxCoeff(), nearest, farthest);
        target += basis.leftCols<2>() * ((low + high) / 2);
    }
}

void Camera::look(StandardView view)
{
    switch (view) {
    case StandardView::Front:
        azimuth = elevation = 0;
        break;
    case StandardView::Back:
        azimuth = pi;
        elevation = 0;
        break;
    case StandardView::Left:
        azimuth = -pi / 2;
        elevation = 0;
        break;
    case StandardView::Right:
        azimuth = pi / 2;
        elevation = 0;
        break;
    case StandardView::Top:
        azimuth = 0;
        elevation = pi / 2;
        break;
    case StandardView::Bottom:
        azimuth = 0;
        elevation = -pi / 2;
        break;
    case StandardView::ThreeQuarter:
        azimuth = -0.7;
        elevation = 0.35;
        break;
    }
}

Camera Camera::between(const Camera& a, const Camera& b, double t)
{
    Camera camera = b;
    camera.target = a.target + t * (b.target - a.target);
    camera.distance = a.distance * std::pow(b.distance / a.distance, t);
    camera.azimuth = wrappedAngle(a.azimuth + t * wrappedAngle(b.azimuth - a.azimuth));
    camera.elevation = a.elevation + t * (b.elevation - a.elevation);
    camera.fieldOfView = a.fieldOfView + t * (b.fieldOfView - a.fieldOfView);
    return t >= 1 ? b : camera;
}

} // namespace bolster
