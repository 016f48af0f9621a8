#include "AreaBrushTool.h"

#include "ViewColors.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bolster {

namespace {

constexpr double grows = 1.25;     // with each key
constexpr double apart = 0.3;      // of the radius: stamps of a stroke
constexpr double stepOfStroke = 6; // pixels
constexpr int mostSteps = 40;      // between two places of the pointer

} // namespace

AreaBrushTool::AreaBrushTool(CoverToolContext& context, double radius, Take take)
    : CoverTool(context)
    , m_radius(radius)
    , m_take(std::move(take))
{}

void AreaBrushTool::press(const CoverPointer& pointer)
{
    m_painting = true;
    m_stampedAt.reset();
    m_strokeAt = pointer.pixel;
    hover(pointer.pixel);
    stamp(pointer.modifiers);
}

/// A quick stroke is told of in few places: what lies between them is painted, too.
bool AreaBrushTool::move(const CoverPointer& pointer)
{
    if (m_painting) {
        const QPointF from = std::exchange(m_strokeAt, pointer.pixel), way = pointer.pixel - from;
        const int steps = std::clamp(static_cast<int>(std::hypot(way.x(), way.y()) / stepOfStroke), 0, mostSteps);
        for (int k = 1; k < steps; ++k) {
            hover(from + way * k / steps);
            stamp(pointer.modifiers);
        }
    }
    hover(pointer.pixel);
    if (m_painting)
        stamp(pointer.modifiers);
    return true;
}

void AreaBrushTool::release(const CoverPointer&)
{
    m_painting = false;
}

void AreaBrushTool::hover(QPointF pixel)
{
    const CoverHit hit = m_context.solid(pixel);
    m_under =
        hit.kind == CoverHit::Kind::Cover ? m_context.nearest(hit.position, CoverHit::Kind::Cover) : std::nullopt;
    m_context.refresh();
}

void AreaBrushTool::stamp(Qt::KeyboardModifiers modifiers)
{
    if (!m_under || (m_stampedAt && (*m_stampedAt - m_under->position).norm() < apart * m_radius))
        return;
    m_stampedAt = m_under->position;
    m_take({m_under->position, m_radius, bool(modifiers & (Qt::ShiftModifier | Qt::ControlModifier))});
}

bool AreaBrushTool::wants(int key) const
{
    return key == Qt::Key_Plus || key == Qt::Key_Minus || key == Qt::Key_Escape;
}

bool AreaBrushTool::keyPress(const QKeyEvent& event)
{
    if (event.key() != Qt::Key_Plus && event.key() != Qt::Key_Minus)
        return false;
    m_radius =
        std::clamp(event.key() == Qt::Key_Plus ? m_radius * grows : m_radius / grows, leastRadius, mostRadius);
    m_take({.radius = m_radius, .paints = false});
    m_context.refresh();
    return true;
}

bool AreaBrushTool::escape()
{
    m_painting = false;
    m_under.reset();
    m_context.refresh();
    m_context.endTool();
    return true;
}

void AreaBrushTool::leave()
{
    m_under.reset();
    m_context.refresh();
}

QString AreaBrushTool::prompt() const
{
    return tr(
        "Drag over the cover to paint the area; with Shift held down to take away. + and \u2212 change the brush. "
        "Esc ends.");
}

/// A ring around the pointer, on the cover.
std::vector<SceneLine> AreaBrushTool::guides() const
{
    if (!m_under)
        return {};
    const Vec3 side = m_under->normal.unitOrthogonal(), other = m_under->normal.cross(side);
    constexpr int corners = 48;
    SceneLine ring;
    for (int k = 0; k <= corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        ring.points.push_back(
            (m_under->position + m_radius * (std::cos(angle) * side + std::sin(angle) * other)).cast<float>());
    }
    ring.color = m_context.colors().accent;
    ring.width = 1.6F;
    ring.hidden = 1;
    return {ring};
}

} // namespace bolster
