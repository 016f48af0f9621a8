// Draws fixation curves on frames.
#pragma once

#include "SurfacePath.h"
#include "SurfaceTool.h"

#include <QCoreApplication>

namespace bolster {

/// Clicks set points on a frame, or on the cover where there is none, or on the end of another curve; the curve
/// follows the surface between them. A double click or Enter ends it, a click on the first point closes it. B
/// switches between smooth and straight, Backspace takes back a point, Escape the curve, then the tool. A drag
/// turns the view.
class FixationDrawTool : public SurfaceTool {
    Q_DECLARE_TR_FUNCTIONS(FixationDrawTool)

public:
    using SurfaceTool::SurfaceTool;

    void press(const SurfacePointer& pointer) override;
    bool move(const SurfacePointer& pointer) override;
    void release(const SurfacePointer& pointer) override;
    void doubleClick(const SurfacePointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    std::vector<SurfaceLine> guides() const override;

private:
    struct Point {
        Vec3 position = Vec3::Zero(); ///< mm
        SurfaceHit::Kind on = SurfaceHit::Kind::Frame;
    };

    std::optional<Point> pointAt(QPointF pixel) const;
    std::optional<Vec3> curveEndAt(QPointF pixel) const;
    bool closes(QPointF pixel) const;
    bool near(const Vec3& point, QPointF pixel) const;
    SurfacePath path(bool closed, bool withNext) const;
    void updatePath();
    void finish(bool closed);
    SurfaceLine ring(const Vec3& centre, double radius) const;

    std::vector<Point> m_points;
    std::optional<Point> m_next; ///< under the pointer
    std::optional<QPointF> m_pressed;
    SurfacePath m_shown;
    bool m_smooth = true;
    bool m_closing = false; ///< a click now closes the curve
};

} // namespace bolster
