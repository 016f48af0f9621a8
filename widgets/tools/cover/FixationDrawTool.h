// Draws fixation curves on frames.
#pragma once

#include "CoverPath.h"
#include "CoverTool.h"
#include "TypedEntry.h"

#include <QCoreApplication>

namespace bolster {

/// Clicks set points on a frame, or on the cover where there is none, or on the end of another curve, or on what a
/// window beside the view offers, such as the border of a form, but for Ctrl; the curve
/// follows the surface between them. Where there is nothing at all they lie on the ground, or as high as the point
/// before. Places can be typed; a curve with such a point goes through the air. A double click or Enter ends it, a
/// click on the first point or C closes it. B switches between smooth along the
/// surface and straight from point to point, Backspace takes back a point,
/// Escape the curve, then the tool. A drag turns the view.
class FixationDrawTool : public CoverTool {
    Q_DECLARE_TR_FUNCTIONS(FixationDrawTool)

public:
    using CoverTool::CoverTool;

    void press(const CoverPointer& pointer) override;
    bool move(const CoverPointer& pointer) override;
    void release(const CoverPointer& pointer) override;
    void doubleClick(const CoverPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    ToolKeys keys() const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    std::optional<SceneNote> note() const override;
    std::vector<SceneLine> guides() const override;

private:
    struct Point {
        Vec3 position = Vec3::Zero();              ///< mm
        CoverHit::Kind on = CoverHit::Kind::Frame; ///< nothing: in the air
    };

    std::optional<Point> pointAt(const CoverPointer& pointer) const;
    std::optional<Point> groundAt(const CoverPointer& pointer) const;
    bool free() const;
    double height() const;
    void pointTyped();
    void enter();
    std::optional<Vec3> curveEndAt(QPointF pixel) const;
    std::optional<Vec3> caughtAt(QPointF pixel, const CoverHit& hit) const;
    bool closes(QPointF pixel) const;
    bool near(const Vec3& point, QPointF pixel) const;
    CoverPath path(bool closed, bool withNext) const;
    void updatePath();
    void finish(bool closed);
    SceneLine ring(const Vec3& centre, double radius) const;

    std::vector<Point> m_points;
    std::optional<Point> m_next; ///< under the pointer
    std::optional<QPointF> m_pressed;
    QPointF m_pointer; ///< pixels
    TypedEntry m_typed;
    bool m_typedGood = false;
    CoverPath m_shown;
    bool m_smooth = true;
    bool m_closing = false; ///< a click now closes the curve
};

} // namespace bolster
