// How the 3D view looks at the scene: a turntable with z up, never upside down.
#pragma once

#include "Viewpoint.h"

#include <optional>

namespace bolster {

/// A viewpoint and the picture that is seen from there: pixels run to the right and down from its top left corner.
class Camera : public Viewpoint {
public:
    enum class StandardView { Front, Back, Left, Right, Top, Bottom, ThreeQuarter };

    struct Ray {
        Vec3 origin = Vec3::Zero();
        Vec3 direction = Vec3::UnitY(); ///< unit
    };

    Vec2 size = {1, 1}; ///< of the picture, pixels

    Vec3 backward() const; ///< unit, from the target to the eye
    Vec3 rightward() const;
    Vec3 upward() const;
    Vec3 eye() const { return target + distance * backward(); }
    /// mm per pixel at the depth of this point.
    double pixelSize(const Vec3& at) const;
    double pixelSize() const { return pixelSize(target); }

    /// World to eye coordinates: x right, y up, -z into the picture.
    Eigen::Matrix4d viewMatrix() const;
    /// Eye to clip coordinates (OpenGL's), with near and far planes that enclose the box.
    Eigen::Matrix4d projectionMatrix(const Box3& box) const;

    /// Nothing for points behind the eye.
    std::optional<Vec2> pixel(const Vec3& point) const;
    Ray ray(const Vec2& pixel) const;
    /// Distance along the view direction, from the eye: larger is farther.
    double depth(const Vec3& point) const { return (eye() - point).dot(backward()); }
    /// The point under the pixel in the plane through `anchor` parallel to the picture.
    Vec3 onPlaneThrough(const Vec3& anchor, const Vec2& pixel) const;

    /// Turns about `pivot`, which stays where it is in the picture.
    void orbit(double azimuthBy, double elevationBy, const Vec3& pivot);
    /// Moves with the pointer: what is at the depth of `anchor` stays under it.
    void pan(const Vec2& pixels, const Vec3& anchor);
    /// `factor` < 1 comes closer; `anchor` stays where it is in the picture.
    void zoom(double factor, const Vec3& anchor);
    /// Looks at the whole box without turning. An empty box changes nothing.
    void fit(const Box3& box);
    void look(StandardView view);

    /// The way from `a` to `b`, t in [0, 1], by the shorter turn.
    static Camera between(const Camera& a, const Camera& b, double t);

    friend bool operator==(const Camera&, const Camera&) = default;
};

} // namespace bolster
