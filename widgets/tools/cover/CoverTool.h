// A tool of the 3D view: turns pointer and key events into edits.
#pragma once

#include "CoverHit.h"
#include "PatchPoint.h"
#include "ViewTool.h"

namespace bolster {

/// What a tool may see of the view it works in.
class CoverToolContext : public ViewToolContext {
public:
    virtual const Camera& toolCamera() const = 0;
    virtual const ViewColors& colors() const = 0;
    virtual CoverHit hit(QPointF pixel) const = 0;
    /// What a curve drawn there would lie on: a frame, or the cover where there is none.
    virtual CoverHit ground(QPointF pixel) const = 0;
    /// The cover, or a frame where there is none, and nothing of what lies on them.
    virtual CoverHit solid(QPointF pixel) const = 0;
    /// The foremost point of a scan near the pixel, mm.
    virtual std::optional<Vec3> scanPoint(ElementId scan, QPointF pixel) const = 0;
    /// The nearest place on a frame or on the cover (`on`).
    virtual std::optional<CoverFoot> nearest(const Vec3& point, CoverHit::Kind on) const = 0;
    /// The same point of the cover (mm) and of the pattern; nothing where there is no cover.
    virtual std::optional<Vec3> onCover(const PatchPoint& point) const = 0;
    virtual std::optional<PatchPoint> inPattern(const CoverHit& solid) const = 0;
    /// Rows of places (mm) to which curves are drawn when near.
    virtual const std::vector<std::vector<Vec3>>& catching() const = 0;
    /// Of what is shown of an element with a placement; its position when nothing is.
    virtual Vec3 middleOf(ElementId id) const = 0;
};

/// The pointer of the left button.
struct CoverPointer {
    QPointF pixel;
    Qt::KeyboardModifiers modifiers;
};

/// What a tool writes beside the pointer.
struct SceneNote {
    QString text;
    QPointF beside;     ///< pixels
    bool typed = false; ///< a field in which the user types
    bool good = true;   ///< it can be understood

    friend bool operator==(const SceneNote&, const SceneNote&) = default;
};

class CoverTool : public ViewTool {
public:
    explicit CoverTool(CoverToolContext& context)
        : m_context(context)
    {}

    virtual void press(const CoverPointer& pointer) = 0;
    /// With the button down or not. False: a drag that is none of the tool's, so it may turn the view.
    virtual bool move(const CoverPointer& pointer) = 0;
    virtual void release(const CoverPointer& pointer) = 0;
    virtual void doubleClick(const CoverPointer&) {}

    /// The control point under the pointer.
    virtual std::optional<std::pair<ElementId, int>> hoveredPoint() const { return std::nullopt; }
    virtual std::optional<SceneNote> note() const { return std::nullopt; }
    /// Drawn with the scene.
    virtual std::vector<SceneLine> guides() const { return {}; }

protected:
    CoverToolContext& m_context;
};

} // namespace bolster
