#include "ScanCutTool.h"

#include "Document.h"
#include "ScanEdits.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr double leastSize = 4; // pixels: less is a click

} // namespace

ScanCutTool::ScanCutTool(CoverToolContext& context, ElementId scan, bool keep)
    : CoverTool(context)
    , m_scan(scan)
    , m_keep(keep)
{}

void ScanCutTool::press(const CoverPointer& pointer)
{
    m_from = pointer.pixel;
    m_to = pointer.pixel;
    m_context.refresh();
}

bool ScanCutTool::move(const CoverPointer& pointer)
{
    if (m_from) {
        m_to = pointer.pixel;
        m_context.refresh();
    }
    return true;
}

void ScanCutTool::release(const CoverPointer& pointer)
{
    if (!m_from)
        return;
    m_to = pointer.pixel;
    const QPointF size = m_to - *m_from;
    if (std::min(std::abs(size.x()), std::abs(size.y())) >= leastSize)
        cut();
    escape();
}

bool ScanCutTool::escape()
{
    m_from.reset();
    m_context.refresh();
    m_context.endTool();
    return true;
}

std::array<Vec2, 4> ScanCutTool::corners() const
{
    const auto [left, right] = std::minmax({m_from->x(), m_to.x()});
    const auto [top, bottom] = std::minmax({m_from->y(), m_to.y()});
    return {Vec2(left, top), Vec2(right, top), Vec2(right, bottom), Vec2(left, bottom)};
}

/// The planes through the sides of the rectangle and the eye.
void ScanCutTool::cut()
{
    const Design& design = m_context.document().design();
    const Scan* scan = design.find<Scan>(m_scan);
    if (!scan)
        return;
    const Camera& camera = m_context.toolCamera();
    const std::array<Vec2, 4> pixels = corners();
    ScanCut region{{}, m_keep};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Camera::Ray a = camera.ray(pixels[i]), b = camera.ray(pixels[(i + 1) % pixels.size()]);
        const Vec3 along = b.origin + b.direction - a.origin - a.direction;
        const Vec3 outside = along.cross(a.direction).normalized();
        const Camera::Ray middle = camera.ray(0.5 * (pixels[0] + pixels[2]));
        const Vec3 inside = middle.origin + middle.direction - a.origin - a.direction;
        const Vec3 normal = inside.dot(outside) > 0 ? Vec3(-outside) : outside;
        region.halfSpaces.push_back(edits::halfSpaceIn(*scan, normal, normal.dot(a.origin)));
    }
    m_context.document().commit(edits::addCut(design, m_scan, std::move(region)));
}

QString ScanCutTool::prompt() const
{
    return m_keep ? tr("Drag a rectangle around what is to be kept of the scan. Esc ends.")
                  : tr("Drag a rectangle over what is to be cut away of the scan. Esc ends.");
}

std::vector<SceneLine> ScanCutTool::guides() const
{
    if (!m_from)
        return {};
    const Camera& camera = m_context.toolCamera();
    SceneLine line;
    for (const Vec2& pixel : corners())
        line.points.push_back(camera.onPlaneThrough(camera.target, pixel).cast<float>());
    line.points.push_back(line.points.front());
    line.color = m_context.colors().accent;
    line.width = 1.6F;
    line.hidden = 1;
    return {line};
}

} // namespace bolster
