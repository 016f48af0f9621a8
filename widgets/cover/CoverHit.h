// What lies under the pointer in the 3D view.
#pragma once

#include "Camera.h"
#include "CoverCurves.h"
#include "FrameShapes.h"
#include "ViewScene.h"

#include <QPointF>

#include <optional>

namespace bolster {

class Selection;

struct CoverHit {
    enum class Kind { Nothing, Cover, Frame, Seam, Curve, Point };

    Kind kind = Kind::Nothing;
    ElementId element = noElement; ///< patch, frame, seam or fixation curve
    int point = -1;                ///< Kind::Point: the control point
    double parameter = 0;          ///< Kind::Curve
    Vec3 position = Vec3::Zero();  ///< mm
    std::uint32_t triangle = 0;    ///< Kind::Cover, Kind::Frame: of what is shown

    explicit operator bool() const { return kind != Kind::Nothing; }
};

/// A place on a frame or on the cover.
struct CoverFoot {
    Vec3 position = Vec3::Zero(); ///< mm
    Vec3 normal = Vec3::UnitZ();  ///< unit
};

/// Asks with the scene as it was when the question is put.
class CoverHitTest {
public:
    explicit CoverHitTest(const FrameShapes& frames)
        : m_frames(frames)
    {}

    /// The cover that is shown now; cheap while the topology stays.
    void setSurface(SurfaceMeshPtr surface);

    /// What is cut away is not hit.
    void setSection(const std::optional<SectionPlane>& section) { m_section = section; }

    struct Question {
        const Camera& camera;
        const CoverCurves* curves;  ///< null: not shown
        const Selection& selection; ///< control points of selected and hovered curves can be hit
        bool seams = true;
    };
    /// Control points before curves before seams before the cover. What is hidden is hit only if it is selected.
    CoverHit hit(const Question& question, QPointF pixel) const;
    /// Only the cover, or a frame where there is none.
    CoverHit hitSolid(const Camera& camera, QPointF pixel) const;
    /// Only a frame, also behind the cover, or the cover where there is none.
    CoverHit hitGround(const Camera& camera, QPointF pixel) const;
    /// The place on the cover or on a frame (`on`) that is nearest to a point, mm; nothing where there is none.
    std::optional<CoverFoot> nearest(const Vec3& point, CoverHit::Kind on) const;

private:
    CoverHit hitPoint(const Question& question, const Vec2& pixel) const;
    CoverHit hitCurve(const Question& question, const Vec2& pixel, const CoverHit& solid) const;
    CoverHit hitSeam(const Question& question, const Vec2& pixel, const CoverHit& solid) const;
    Camera::Ray keptRay(const Camera::Ray& ray) const;
    CoverHit hitCover(const Camera::Ray& ray) const;
    CoverHit hitFrame(const Camera::Ray& ray) const;
    const TriangleRays& rays() const;

    SurfaceMeshPtr m_surface;
    std::optional<SectionPlane> m_section;
    mutable TriangleRays m_rays; ///< built when the first question comes
    mutable SurfaceMeshPtr m_raysOf;
    const FrameShapes& m_frames;
};

} // namespace bolster
