#include "FrameEdgeTool.h"

#include "Document.h"
#include "ElementEdits.h"
#include "SceneMarks.h"
#include "Selection.h"
#include "ToolGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr double edgeReach = 9; // pixels
constexpr double behind = 2;    // pixels: so far an edge may lie in the frame that it belongs to

} // namespace

FrameEdgeTool::FrameEdgeTool(CoverToolContext& context, OfferedEdgesPtr edges)
    : CoverTool(context)
    , m_offered(std::move(edges))
    , m_single(withSpheres(m_offered->single))
    , m_joined(withSpheres(m_offered->joined))
{}

FrameEdgeTool::Edges FrameEdgeTool::withSpheres(const std::vector<FrameEdge>& edges)
{
    Edges known{edges, {}};
    for (const FrameEdge& edge : edges) {
        Box3 box;
        for (const Vec3& point : edge.points)
            box.extend(point);
        known.spheres.emplace_back(box.center(), box.diagonal().norm() / 2);
    }
    return known;
}

/// How far away the edge is where it passes the pixel; nothing when it does not.
std::optional<double> FrameEdgeTool::depthAt(const FrameEdge& edge, const Vec2& pixel) const
{
    const Camera& camera = m_context.toolCamera();
    double best = edgeReach;
    std::optional<Vec3> at;
    std::optional<Vec2> from = camera.pixel(edge.points.front());
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
        const std::optional<Vec2> to = camera.pixel(edge.points[i]);
        if (from && to) {
            const Vec2 way = *to - *from;
            const double length = way.squaredNorm();
            const double share = length > 0 ? std::clamp((pixel - *from).dot(way) / length, 0.0, 1.0) : 0;
            if (const double off = (*from + share * way - pixel).norm(); off <= best) {
                best = off;
                at = edge.points[i - 1] + share * (edge.points[i] - edge.points[i - 1]);
            }
        }
        from = to;
    }
    if (!at || isHidden(*at))
        return std::nullopt;
    return camera.depth(*at) + best * camera.pixelSize(*at); // of two at one depth the nearer to the pointer
}

/// By a frame: the cover mostly lies over it.
bool FrameEdgeTool::isHidden(const Vec3& point) const
{
    const Camera& camera = m_context.toolCamera();
    const std::optional<Vec2> pixel = camera.pixel(point);
    if (!pixel)
        return true;
    const CoverHit before = m_context.ground({pixel->x(), pixel->y()});
    const double slack = behind * camera.pixelSize(point) + 1;
    return before.kind == CoverHit::Kind::Frame && camera.depth(before.position) < camera.depth(point) - slack;
}

const FrameEdge* FrameEdgeTool::edgeAt(const CoverPointer& pointer) const
{
    const Camera& camera = m_context.toolCamera();
    const Vec2 pixel(pointer.pixel.x(), pointer.pixel.y());
    const Edges& known = pointer.modifiers & Qt::ControlModifier ? m_single : m_joined;
    const FrameEdge* found = nullptr;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < known.edges.size(); ++i) {
        const auto& [middle, radius] = known.spheres[i];
        const Camera::Ray ray = camera.ray(pixel);
        const Vec3 to = middle - ray.origin;
        const double off = (to - to.dot(ray.direction) * ray.direction).norm();
        if (off > radius + 2 * edgeReach * camera.pixelSize(middle))
            continue;
        if (const auto depth = depthAt(known.edges[i], pixel); depth && *depth < nearest) {
            nearest = *depth;
            found = &known.edges[i];
        }
    }
    return found;
}

void FrameEdgeTool::press(const CoverPointer& pointer)
{
    m_pressed = pointer.pixel;
}

bool FrameEdgeTool::move(const CoverPointer& pointer)
{
    if (m_pressed) {
        const QPointF way = pointer.pixel - *m_pressed;
        if (std::hypot(way.x(), way.y()) < dragDistance)
            return true;
        m_pressed.reset();
        leave();
        return false;
    }
    if (const FrameEdge* const edge = edgeAt(pointer); edge != m_hovered) {
        m_hovered = edge;
        m_context.refresh();
    }
    return true;
}

void FrameEdgeTool::release(const CoverPointer& pointer)
{
    if (!m_pressed)
        return;
    m_pressed.reset();
    if (const FrameEdge* const edge = edgeAt(pointer))
        fix(*edge);
    else
        m_context.report(tr("There is no edge of a frame here. A curve of your own: Frame > Draw fixation curve."));
}

/// One that is there already is selected.
void FrameEdgeTool::fix(const FrameEdge& edge)
{
    const std::optional<BSpline3> curve = curveOnEdge(edge);
    if (!curve)
        return;
    Document& document = m_context.document();
    int count = 1;
    std::optional<ElementId> there;
    document.design().each<FixationCurve>([&](ElementId id, const FixationCurve& fixation) {
        ++count;
        if (fixation.curve == *curve)
            there = id;
    });
    if (!there) {
        const FixationCurve fixation{tr("Fixation %1").arg(count).toStdString(), *curve};
        const Edit added = edits::addElement(document.design(), makeElement(fixation));
        document.commit(added);
        there = added.changes.front().id;
    }
    m_context.selection().set({*there});
    m_context.refresh();
}

bool FrameEdgeTool::wants(int key) const
{
    return key == Qt::Key_Escape;
}

bool FrameEdgeTool::escape()
{
    m_context.endTool();
    return true;
}

void FrameEdgeTool::leave()
{
    m_hovered = nullptr;
    m_context.refresh();
}

QString FrameEdgeTool::prompt() const
{
    if (!m_hovered)
        return tr(
            "Click an edge of a frame to make a fixation curve of it \u2013 drag turns the view, Esc ends the "
            "tool");
    return tr(
        "Click to make a fixation curve of this edge \u2013 Ctrl takes it alone, without those in which it goes "
        "on smoothly");
}

std::vector<SceneLine> FrameEdgeTool::guides() const
{
    if (!m_hovered)
        return {};
    SceneLine line;
    for (const Vec3& point : m_hovered->points)
        line.points.push_back(point.cast<float>());
    line.color = fixationCurveColor(m_context.colors());
    line.width = 3.2F;
    line.hidden = 0.95F; // mostly the cover lies over the frame
    line.casing = 0.8F;
    return {line};
}

} // namespace bolster
