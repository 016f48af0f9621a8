#include "FixationDrawTool.h"

#include "Document.h"
#include "DrawingKeys.h"
#include "ElementEdits.h"
#include "SceneMarks.h"
#include "SegmentDistance.h"
#include "Selection.h"
#include "ToolGeometry.h"
#include "Units.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

// Pixels.
constexpr double curveReach = 9;
constexpr double curvePointRadius = 4.5;

constexpr double groundGrid = 10; // mm

} // namespace

bool FixationDrawTool::near(const Vec3& point, QPointF pixel) const
{
    const std::optional<Vec2> at = m_context.toolCamera().pixel(point);
    return at && std::hypot(at->x() - pixel.x(), at->y() - pixel.y()) <= curveReach;
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

/// Not on the far side of what is hit.
std::optional<Vec3> FixationDrawTool::caughtAt(QPointF pixel, const CoverHit& hit) const
{
    constexpr double mostAside = 3; // times its reach, in space: where the surface is seen at a flat angle
    const Camera& camera = m_context.toolCamera();
    const Vec2 at(pixel.x(), pixel.y());
    std::optional<Vec3> found;
    double nearest = curveReach;
    const auto look = [&](const Vec3& a, const Vec3& b) {
        const std::optional<Vec2> from = camera.pixel(a), to = camera.pixel(b);
        if (!from || !to)
            return;
        const Vec2 on = nearestOnSegment<2>(at, *from, *to);
        const double distance = (on - at).norm(), length = (*to - *from).norm();
        const Vec3 place = length > 0 ? Vec3(a + (on - *from).norm() / length * (b - a)) : a;
        if (distance > nearest ||
            (hit && (place - hit.position).norm() > mostAside * curveReach * camera.pixelSize(place)))
            return;
        nearest = distance;
        found = place;
    };
    for (const std::vector<Vec3>& row : m_context.catching())
        for (std::size_t k = 1; k < row.size(); ++k)
            look(row[k - 1], row[k]);
    return found;
}

std::optional<FixationDrawTool::Point> FixationDrawTool::pointAt(const CoverPointer& pointer) const
{
    const CoverHit hit = m_context.ground(pointer.pixel);
    if (const std::optional<Vec3> end = curveEndAt(pointer.pixel))
        return Point{*end, hit ? hit.kind : CoverHit::Kind::Frame};
    if (!(pointer.modifiers & Qt::ControlModifier))
        if (const std::optional<Vec3> place = caughtAt(pointer.pixel, hit))
            return Point{*place, hit ? hit.kind : CoverHit::Kind::Frame};
    return hit ? std::optional(Point{hit.position, hit.kind}) : groundAt(pointer);
}

/// Only where nothing else could be meant: a click that just misses the frame must not set a point behind it.
std::optional<FixationDrawTool::Point> FixationDrawTool::groundAt(const CoverPointer& pointer) const
{
    bool other = m_context.nearest(Vec3::Zero(), CoverHit::Kind::Cover).has_value();
    m_context.document().design().each<Frame>([&](ElementId, const Frame&) { other = true; });
    if (other && !free())
        return std::nullopt;
    const Camera::Ray ray = m_context.toolCamera().ray({pointer.pixel.x(), pointer.pixel.y()});
    const double way = (height() - ray.origin.z()) / ray.direction.z();
    Vec3 at = ray.origin + way * ray.direction;
    if (!(way > 0) || !at.allFinite() || way > 20 * m_context.toolCamera().distance)
        return std::nullopt; // the sky
    if (!(pointer.modifiers & Qt::ControlModifier))
        at.head<2>() = groundGrid * (at.head<2>() / groundGrid).array().round();
    return Point{at, CoverHit::Kind::Nothing};
}

/// Through the air: it has a point that lies on nothing.
bool FixationDrawTool::free() const
{
    return std::ranges::any_of(m_points, [](const Point& p) { return p.on == CoverHit::Kind::Nothing; });
}

double FixationDrawTool::height() const
{
    return m_points.empty() ? 0 : m_points.back().position.z();
}

bool FixationDrawTool::closes(QPointF pixel) const
{
    return m_points.size() >= 3 && near(m_points.front().position, pixel);
}

void FixationDrawTool::press(const CoverPointer& pointer)
{
    if (m_typed.open())
        enter(); // the place that is shown
    else
        m_pressed = pointer.pixel;
}

bool FixationDrawTool::move(const CoverPointer& pointer)
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
    m_pointer = pointer.pixel;
    m_closing = !m_typed.open() && closes(pointer.pixel);
    if (!m_typed.open())
        m_next = m_closing ? std::nullopt : pointAt(pointer);
    updatePath();
    return true;
}

void FixationDrawTool::release(const CoverPointer& pointer)
{
    if (!m_pressed)
        return;
    m_pressed.reset();
    if (closes(pointer.pixel)) {
        finish(true);
        return;
    }
    const std::optional<Point> point = pointAt(pointer);
    if (point)
        m_points.push_back(*point);
    else
        m_context.report(tr("There is neither a frame nor the cover here: click on one, or type x, y, z."));
    m_next.reset();
    updatePath();
}

void FixationDrawTool::doubleClick(const CoverPointer&)
{
    m_pressed.reset();
    finish(false); // its first click has set the last point
}

bool FixationDrawTool::wants(int key) const
{
    return m_typed.wants(key) || isDrawingKey(key, true) || key == Qt::Key_C || key == Qt::Key_Escape;
}

bool FixationDrawTool::keyPress(const QKeyEvent& event)
{
    if (m_typed.keyPress(event)) {
        pointTyped();
        return true;
    }
    if (event.key() == Qt::Key_C)
        finish(true);
    else if (!pressDrawingKey(event.key(), m_points, &m_smooth, [this] { enter(); }))
        return false;
    updatePath();
    return true;
}

void FixationDrawTool::pointTyped()
{
    const std::optional<Vec3> place = typedPlace(m_typed.text(), height());
    m_typedGood = place.has_value();
    m_closing = false;
    m_next = place ? std::optional(Point{*place, CoverHit::Kind::Nothing}) : std::nullopt;
    updatePath();
}

void FixationDrawTool::enter()
{
    if (!m_typed.open()) {
        finish(false);
    } else if (m_typedGood) {
        m_points.push_back(*m_next);
        m_next.reset();
        m_typed.clear();
    } else {
        m_context.report(tr("\"%1\" is no place: try 250, -100, 40").arg(m_typed.text()));
    }
}

ToolKeys FixationDrawTool::keys() const
{
    if (m_points.empty())
        return {};
    ToolKeys keys = DrawingKeys::ofLine(true);
    keys.insert(1, {Qt::Key_C, tr("&Close the curve")});
    return keys;
}

bool FixationDrawTool::escape()
{
    if (m_typed.open()) {
        m_typed.clear();
        m_next.reset();
        updatePath();
        return true;
    }
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

/// What lies on the cover alone follows the cover, what has a point in the air nothing, any other curve the frame;
/// and a straight one nothing at all.
CoverPath FixationDrawTool::path(bool closed, bool withNext) const
{
    std::vector<Vec3> through;
    bool onCover = !m_points.empty();
    const auto add = [&](const Point& point) {
        through.push_back(point.position);
        onCover = onCover && point.on == CoverHit::Kind::Cover;
    };
    for (const Point& point : m_points)
        add(point);
    if (withNext && m_next)
        add(*m_next);
    const auto on = onCover ? CoverHit::Kind::Cover : CoverHit::Kind::Frame;
    const bool air = free() || (withNext && m_next && m_next->on == CoverHit::Kind::Nothing);
    return pathAlong(through, closed, m_smooth, [&](const Vec3& p) -> std::optional<Vec3> {
        if (air)
            return std::nullopt;
        const std::optional<CoverFoot> foot = m_context.nearest(p, on);
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
    const CoverPath along = path(closed, false);
    const std::optional<BSpline3> curve = curveAlong(along);
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
    if (m_typed.open())
        return tr("Enter sets the point: x, y, z \u2013 without z it is as high as the last one");
    if (m_points.empty())
        return tr(
            "Click on a frame to begin a fixation curve, or type x, y, z \u2013 drag turns the view, Esc ends "
            "the tool");
    if (m_closing)
        return tr("Click to close the curve");
    return m_smooth
               ? tr("Click or type the next point, Enter ends, C closes \u2013 B makes it straight, Backspace "
                    "takes a point back")
               : tr("Click or type the next point, Enter ends, C closes \u2013 straight from point to point, "
                    "whatever lies between: B makes it smooth along the surface, Backspace takes a point back");
}

std::optional<SceneNote> FixationDrawTool::note() const
{
    if (m_typed.open())
        return SceneNote{m_typed.text(), m_pointer, true, m_typedGood};
    if (!m_next || m_next->on != CoverHit::Kind::Nothing)
        return std::nullopt;
    const Vec3& at = m_next->position;
    return SceneNote{
        tr("%1, %2, %3")
            .arg(steadyLengthFigure(at.x(), 0), steadyLengthFigure(at.y(), 0), steadyLengthText(at.z(), 0)),
        m_pointer};
}

SceneLine FixationDrawTool::ring(const Vec3& centre, double radius) const
{
    constexpr int sides = 16;
    const Camera& camera = m_context.toolCamera();
    const double size = radius * camera.pixelSize(centre);
    SceneLine line;
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

std::vector<SceneLine> FixationDrawTool::guides() const
{
    std::vector<SceneLine> lines;
    if (!m_shown.points.empty()) {
        SceneLine line;
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
        lines.push_back(
            ring(m_points[i].position, i == 0 && m_closing ? curvePointRadius + 2.5 : curvePointRadius));
    if (m_next)
        lines.push_back(ring(m_next->position, curvePointRadius - 1));
    return lines;
}

} // namespace bolster
