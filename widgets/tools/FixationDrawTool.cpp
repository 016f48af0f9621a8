#include "FixationDrawTool.h"

#include "Document.h"
#include "DrawingKeys.h"
#include "ElementEdits.h"
#include "Selection.h"
#include "SurfaceMarks.h"

#include <QKeyEvent>

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

// Pixels.
constexpr double reach = 9;
constexpr double dragDistance = 4;
constexpr double pointRadius = 4.5;

} // namespace

bool FixationDrawTool::near(const Vec3& point, QPointF pixel) const
{
    const std::optional<Vec2> at = m_context.toolCamera().pixel(point);
    return at && std::hypot(at->x() - pixel.x(), at->y() - pixel.y()) <= reach;
}

/// Curves that meet can fix one corner of a patch together.
std::optional<Vec3> FixationDrawTool::curveEndAt(QPointF pixel) const
{
    std::optional<Vec3> found;
    m_context.document().design().each<FixationCurve>([&](ElementId, const FixationCurve& fixation) {
        if (fixation.curve.empty() || fixation.curve.closed())
            return;
        for (const double t : {fixation.curve.domainStart(), fixation.curve.domainEnd()})
            if (const Vec3 end = fixation.curve.at(t); near(end, pixel))
                found = end;
    });
    return found;
}

std::optional<FixationDrawTool::Point> FixationDrawTool::pointAt(QPointF pixel) const
{
    const SurfaceHit hit = m_context.ground(pixel);
    if (const std::optional<Vec3> end = curveEndAt(pixel))
        return Point{*end, hit ? hit.kind : SurfaceHit::Kind::Frame};
    return hit ? std::optional(Point{hit.position, hit.kind}) : std::nullopt;
}

bool FixationDrawTool::closes(QPointF pixel) const
{
    return m_points.size() >= 3 && near(m_points.front().position, pixel);
}

void FixationDrawTool::press(const SurfacePointer& pointer)
{
    m_pressed = pointer.pixel;
}

bool FixationDrawTool::move(const SurfacePointer& pointer)
{
    if (m_pressed) {
        const QPointF way = pointer.pixel - *m_pressed;
        if (std::hypot(way.x(), way.y()) < dragDistance)
            return true;
        m_pressed.reset();
        m_next.reset();
        updatePath();
        return false;
    }
    m_closing = closes(pointer.pixel);
    m_next = m_closing ? std::nullopt : pointAt(pointer.pixel);
    updatePath();
    return true;
}

void FixationDrawTool::release(const SurfacePointer& pointer)
{
    if (!m_pressed)
        return;
    m_pressed.reset();
    if (closes(pointer.pixel)) {
        finish(true);
        return;
    }
    const std::optional<Point> point = pointAt(pointer.pixel);
    if (point)
        m_points.push_back(*point);
    else
        m_context.report(tr("There is neither a frame nor the cover here."));
    m_next.reset();
    updatePath();
}

void FixationDrawTool::doubleClick(const SurfacePointer&)
{
    m_pressed.reset();
    finish(false); // its first click has set the last point
}

bool FixationDrawTool::wants(int key) const
{
    return isDrawingKey(key, true) || key == Qt::Key_Escape;
}

bool FixationDrawTool::keyPress(const QKeyEvent& event)
{
    if (!pressDrawingKey(event.key(), m_points, &m_smooth, [this] { finish(false); }))
        return false;
    updatePath();
    return true;
}

bool FixationDrawTool::escape()
{
    if (m_points.empty())
        m_context.endTool();
    m_points.clear();
    m_next.reset();
    m_pressed.reset();
    m_closing = false;
    updatePath();
    return true;
}

void FixationDrawTool::leave()
{
    m_next.reset();
    m_closing = false;
    updatePath();
}

/// A piece between two points on the cover follows the cover, any other one the frame.
SurfacePath FixationDrawTool::path(bool closed, bool withNext) const
{
    std::vector<Vec3> through;
    bool onCover = !m_points.empty();
    const auto add = [&](const Point& point) {
        through.push_back(point.position);
        onCover = onCover && point.on == SurfaceHit::Kind::Cover;
    };
    for (const Point& point : m_points)
        add(point);
    if (withNext && m_next)
        add(*m_next);
    const auto on = onCover ? SurfaceHit::Kind::Cover : SurfaceHit::Kind::Frame;
    return pathAlong(through, closed, m_smooth, [&](const Vec3& p) -> std::optional<Vec3> {
        const std::optional<SurfaceFoot> foot = m_context.nearest(p, on);
        return foot ? std::optional(foot->position) : std::nullopt;
    });
}

void FixationDrawTool::updatePath()
{
    m_shown = path(m_closing, true);
    m_context.refresh();
}

void FixationDrawTool::finish(bool closed)
{
    const std::optional<BSpline3> curve = curveAlong(path(closed, false), !m_smooth);
    if (!curve) {
        m_context.report(tr("A curve needs two points, a closed one three."));
        return;
    }
    Document& document = m_context.document();
    int count = 1;
    document.design().each<FixationCurve>([&](ElementId, const FixationCurve&) { ++count; });
    const FixationCurve fixation{tr("Fixation %1").arg(count).toStdString(), *curve};
    const Edit added = edits::addElement(document.design(), makeElement(fixation));
    m_points.clear();
    m_next.reset();
    m_closing = false;
    updatePath();
    document.commit(added);
    m_context.selection().set({added.changes.front().id});
    m_context.endTool();
}

QString FixationDrawTool::prompt() const
{
    if (m_points.empty())
        return tr("Click on a frame to begin a fixation curve, drag to turn the view \u2013 Esc ends the tool");
    if (m_closing)
        return tr("Click to close the curve");
    return m_smooth
               ? tr("Click for the next point, double click or Enter ends \u2013 B makes it straight, Backspace "
                    "takes a point back")
               : tr("Click for the next point, double click or Enter ends \u2013 B makes it smooth, Backspace "
                    "takes a point back");
}

SurfaceLine FixationDrawTool::ring(const Vec3& centre, double radius) const
{
    constexpr int sides = 16;
    const Camera& camera = m_context.toolCamera();
    const double size = radius * camera.pixelSize(centre);
    SurfaceLine line;
    for (int k = 0; k <= sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        const Vec3 at = centre + size * (std::cos(angle) * camera.rightward() + std::sin(angle) * camera.upward());
        line.points.push_back(at.cast<float>());
    }
    line.color = m_context.colors().accent;
    line.width = 1.8F;
    line.hidden = 0.8F;
    line.casing = 0.6F;
    return line;
}

std::vector<SurfaceLine> FixationDrawTool::guides() const
{
    std::vector<SurfaceLine> lines;
    if (!m_shown.points.empty()) {
        SurfaceLine line;
        for (const Vec3& p : m_shown.points)
            line.points.push_back(p.cast<float>());
        if (m_shown.closed)
            line.points.push_back(line.points.front());
        line.color = fixationCurveColor(m_context.colors());
        line.width = 2.6F;
        line.hidden = 0.95F; // mostly the cover lies over the frame that is drawn on
        line.casing = 0.8F;
        lines.push_back(std::move(line));
    }
    for (std::size_t i = 0; i < m_points.size(); ++i)
        lines.push_back(ring(m_points[i].position, i == 0 && m_closing ? pointRadius + 2.5 : pointRadius));
    if (m_next)
        lines.push_back(ring(m_next->position, pointRadius - 1));
    return lines;
}

} // namespace bolster
