// What lies under the pointer in the 3D view.
#pragma once

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

    explicit operator bool() const { return kind != Kind::Nothing; }
};

/// Asks with the scene as it was when the question is put.
class SurfaceHitTest {
public:
    explicit SurfaceHitTest(const FrameShapes& frames)
        : m_frames(frames)
    {}

    /// The cover that is shown now; cheap while the topology stays.
    void setSurface(SurfaceMeshPtr surface);

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

private:
    SurfaceHit hitPoint(const Question& question, const Vec2& pixel) const;
    SurfaceHit hitCurve(const Question& question, const Vec2& pixel, const SurfaceHit& solid) const;
    SurfaceHit hitSeam(const Question& question, const Vec2& pixel, const SurfaceHit& solid) const;
    const SurfaceRays& rays() const;

    SurfaceMeshPtr m_surface;
    mutable SurfaceRays m_rays; ///< built when the first question comes
    mutable SurfaceMeshPtr m_raysOf;
    const FrameShapes& m_frames;
};

} // namespace bolster
