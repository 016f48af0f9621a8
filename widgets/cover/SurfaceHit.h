// What lies under the pointer in the 3D view.
#pragma once

#include "Camera.h"
#include "FrameShapes.h"
#include "SurfaceCurves.h"
#include "SurfaceScene.h"

#include <QPointF>

#include <optional>

namespace bolster {

class Selection;

struct SurfaceHit {
    enum class Kind { Nothing, Cover, Frame, Seam, Curve, Point };

    Kind kind = Kind::Nothing;
    ElementId element = settingsId; ///< patch, frame, seam or fixation curve
    int point = -1;                 ///< Kind::Point: the control point
    double parameter = 0;           ///< Kind::Curve
    Vec3 position = Vec3::Zero();   ///< mm
    std::uint32_t triangle = 0;     ///< Kind::Cover, Kind::Frame: of what is shown

    explicit operator bool() const { return kind != Kind::Nothing; }
};

/// A place on a frame or on the cover.
struct SurfaceFoot {
    Vec3 position = Vec3::Zero(); ///< mm
    Vec3 normal = Vec3::UnitZ();  ///< unit
};

/// Asks with the scene as it was when the question is put.
class SurfaceHitTest {
public:
    explicit SurfaceHitTest(const FrameShapes& frames)
        : m_frames(frames)
    {}

    /// The cover that is shown now; cheap while the topology stays.
    void setSurface(SurfaceMeshPtr surface);

    /// What is cut away is not hit.
    void setSection(const std::optional<SectionPlane>& section) { m_section = section; }

    struct Question {
        const Camera& camera;
        const SurfaceCurves* curves; ///< null: not shown
        const Selection& selection;  ///< control points of selected and hovered curves can be hit
        bool seams = true;
    };
    /// Control points before curves before seams before the cover. What is hidden is hit only if it is selected.
    SurfaceHit hit(const Question& question, QPointF pixel) const;
    /// Only the cover, or a frame where there is none.
    SurfaceHit hitSolid(const Camera& camera, QPointF pixel) const;
    /// Only a frame, also behind the cover, or the cover where there is none.
    SurfaceHit hitGround(const Camera& camera, QPointF pixel) const;
    /// The place on the cover or on a frame (`on`) that is nearest to a point, mm; nothing where there is none.
    std::optional<SurfaceFoot> nearest(const Vec3& point, SurfaceHit::Kind on) const;

private:
    SurfaceHit hitPoint(const Question& question, const Vec2& pixel) const;
    SurfaceHit hitCurve(const Question& question, const Vec2& pixel, const SurfaceHit& solid) const;
    SurfaceHit hitSeam(const Question& question, const Vec2& pixel, const SurfaceHit& solid) const;
    Camera::Ray keptRay(const Camera::Ray& ray) const;
    SurfaceHit hitCover(const Camera::Ray& ray) const;
    SurfaceHit hitFrame(const Camera::Ray& ray) const;
    const SurfaceRays& rays() const;

    SurfaceMeshPtr m_surface;
    std::optional<SectionPlane> m_section;
    mutable SurfaceRays m_rays; ///< built when the first question comes
    mutable SurfaceMeshPtr m_raysOf;
    const FrameShapes& m_frames;
};

} // namespace bolster
