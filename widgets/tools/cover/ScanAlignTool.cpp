#include "ScanAlignTool.h"

#include "Document.h"
#include "ToolGeometry.h"

#include <QKeyEvent>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace bolster {

namespace {

constexpr std::size_t wantedPairs = 3;
constexpr double pairRadius = 6; // pixels

/// One for each pair: both of its places have it.
QColor pairColor(std::size_t pair)
{
    constexpr std::array<QRgb, wantedPairs> colors = {0xffd0342c, 0xff2c9a3f, 0xffc02fb0};
    return QColor(colors[pair % colors.size()]);
}

} // namespace

ScanAlignTool::ScanAlignTool(CoverToolContext& context, ElementId scan, Done done, std::vector<ScanMark> marks)
    : CoverTool(context)
    , m_scan(scan)
    , m_done(std::move(done))
    , m_marks(std::move(marks))
{
    if (m_marks.size() < wantedPairs)
        return;
    m_begun = m_marks.back().onScan;
    m_marks.pop_back();
}

const Scan* ScanAlignTool::scan() const
{
    return m_context.document().design().find<Scan>(m_scan);
}

void ScanAlignTool::press(const CoverPointer& pointer)
{
    m_pressed = pointer.pixel;
}

bool ScanAlignTool::move(const CoverPointer& pointer)
{
    m_pointer = pointer.pixel;
    if (m_pressed) {
        const QPointF way = pointer.pixel - *m_pressed;
        if (std::hypot(way.x(), way.y()) < dragDistance)
            return true;
        m_pressed.reset();
        m_next.reset();
        m_context.refresh();
        return false;
    }
    if (onTarget()) {
        const CoverHit hit = m_context.solid(pointer.pixel);
        m_next = hit ? std::optional(hit.position) : std::nullopt;
    } else {
        m_next = m_context.scanPoint(m_scan, pointer.pixel);
    }
    m_context.refresh();
    return true;
}

void ScanAlignTool::release(const CoverPointer& pointer)
{
    if (!m_pressed)
        return;
    m_pressed.reset();
    m_next.reset();
    if (!scan())
        m_context.endTool();
    else if (onTarget())
        takeTarget(pointer.pixel);
    else
        takeScan(pointer.pixel);
    m_context.refresh();
}

void ScanAlignTool::takeScan(QPointF pixel)
{
    if (const std::optional<Vec3> at = m_context.scanPoint(m_scan, pixel))
        m_begun = scan()->filePoint(*at);
    else
        m_context.report(tr("There is no point of the scan here: click on one."));
}

void ScanAlignTool::takeTarget(QPointF pixel)
{
    const CoverHit hit = m_context.solid(pixel);
    if (!hit) {
        m_context.report(
            tr("There is neither a frame nor the cover here: click where that place of the scan belongs."));
        return;
    }
    const bool frame = hit.kind == CoverHit::Kind::Frame;
    m_marks.push_back({*m_begun, hit.position, frame, frame ? hit.element : noElement});
    m_begun.reset();
    if (m_marks.size() < wantedPairs)
        return;
    m_context.endTool();
    m_done(m_scan, std::exchange(m_marks, {}));
}

void ScanAlignTool::takeBack()
{
    if (m_begun) {
        m_begun.reset();
    } else if (!m_marks.empty()) {
        m_begun = m_marks.back().onScan;
        m_marks.pop_back();
    }
    m_next.reset();
    m_context.refresh();
}

bool ScanAlignTool::wants(int key) const
{
    return key == Qt::Key_Escape || (key == Qt::Key_Backspace && !keys().empty());
}

bool ScanAlignTool::keyPress(const QKeyEvent& event)
{
    if (event.key() != Qt::Key_Backspace)
        return false;
    takeBack();
    return true;
}

ToolKeys ScanAlignTool::keys() const
{
    if (m_marks.empty() && !m_begun)
        return {};
    return {{Qt::Key_Backspace, tr("Take the last place &back")}};
}

bool ScanAlignTool::escape()
{
    if (m_marks.empty() && !m_begun)
        m_context.endTool();
    m_marks.clear();
    m_begun.reset();
    m_pressed.reset();
    m_next.reset();
    m_context.refresh();
    return true;
}

void ScanAlignTool::leave()
{
    m_next.reset();
    m_context.refresh();
}

QString ScanAlignTool::prompt() const
{
    if (!scan())
        return tr("The scan is no longer there \u2013 Esc ends the tool");
    if (onTarget())
        return tr("Click on the frame or the cover where place %1 of the scan belongs \u2013 Backspace takes it "
                  "back")
            .arg(number());
    if (m_marks.empty())
        return tr(
            "Click on a place of the scan that can be told from others, such as a corner \u2013 drag turns the "
            "view, Esc ends the tool");
    return tr("Click on place %1 of 3 of the scan, far from the others \u2013 Backspace takes one back")
        .arg(number());
}

std::optional<SceneNote> ScanAlignTool::note() const
{
    if (!m_next)
        return std::nullopt;
    return SceneNote{onTarget() ? tr("%1: where it belongs").arg(number()) : tr("%1: on the scan").arg(number()),
                     m_pointer};
}

SceneLine ScanAlignTool::ring(const Vec3& centre, double radius, std::size_t pair) const
{
    constexpr int sides = 20;
    const Camera& camera = m_context.toolCamera();
    const double size = radius * camera.pixelSize(centre);
    SceneLine line;
    for (int k = 0; k <= sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        const Vec3 at = centre + size * (std::cos(angle) * camera.rightward() + std::sin(angle) * camera.upward());
        line.points.push_back(at.cast<float>());
    }
    line.color = pairColor(pair);
    line.width = 2.2F;
    line.hidden = 1;
    line.casing = 0.8F;
    return line;
}

std::vector<SceneLine> ScanAlignTool::guides() const
{
    std::vector<SceneLine> lines;
    const Scan* const aligned = scan();
    if (!aligned)
        return lines;
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        const Vec3 from = aligned->placed(m_marks[i].onScan), to = m_marks[i].onTarget;
        lines.push_back(ring(from, pairRadius, i));
        lines.push_back(ring(to, pairRadius, i));
        lines.push_back({{from.cast<float>(), to.cast<float>()}, pairColor(i), 1.2F, 0.6F});
    }
    if (m_begun)
        lines.push_back(ring(aligned->placed(*m_begun), pairRadius, m_marks.size()));
    if (m_next)
        lines.push_back(ring(*m_next, pairRadius - 2, m_marks.size()));
    return lines;
}

} // namespace bolster
