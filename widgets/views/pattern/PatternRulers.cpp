#include "PatternRulers.h"

#include "DrawingAids.h"
#include "PatternGrid.h"
#include "PatternNavigation.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double leastLabelGap = 58;
constexpr double leastTickGap = 5;
constexpr double grabReach = 6;

} // namespace

PatternRuler::PatternRuler(const PatternNavigation& navigation, DrawingAids& aids, Qt::Orientation orientation,
                           QWidget& view)
    : QWidget(&view)
    , m_navigation(navigation)
    , m_aids(aids)
    , m_view(view)
    , m_orientation(orientation)
{
    setMouseTracking(true);
    setCursor(level() ? Qt::SplitVCursor : Qt::SplitHCursor);
    setToolTip(level() ? tr("Drag down for a level guide. Marks move upright guides; drag them off to remove them.")
                       : tr("Drag to the right for an upright guide. Marks move level guides; drag them off to "
                            "remove them."));
    hide();
}

void PatternRuler::showPointer(const std::optional<Vec2>& layout)
{
    m_pointer = layout;
    update();
}

void PatternRuler::place()
{
    // The top one has the corner.
    setGeometry(level() ? QRect(0, 0, m_view.width(), thickness)
                        : QRect(0, thickness, thickness, m_view.height() - thickness));
}

double PatternRuler::along(const Vec2& layout) const
{
    const QPointF pixel = m_navigation.transform().toPixels(layout) - QPointF(pos());
    return level() ? pixel.x() : pixel.y();
}

void PatternRuler::paintEvent(QPaintEvent*)
{
    const ViewColors colors = ViewColors::of(m_view.palette());
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(colors.gridMajor);
    if (level())
        painter.drawLine(0, height() - 1, width(), height() - 1);
    else
        painter.drawLine(width() - 1, 0, width() - 1, height());
    paintScale(painter);
    paintMarks(painter);
}

void PatternRuler::paintScale(QPainter& painter) const
{
    const ViewColors colors = ViewColors::of(m_view.palette());
    const PatternTransform& transform = m_navigation.transform();
    const auto [step, parts] = rulerStep(transform.scale(), leastLabelGap, leastTickGap);
    const Box2 box = transform.visible(m_view.size());
    const int axis = level() ? 0 : 1;
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.8);
    painter.setFont(small);
    const auto first = static_cast<long long>(std::floor(box.min()[axis] / step)) * parts;
    const auto last = static_cast<long long>(std::ceil(box.max()[axis] / step)) * parts;
    for (long long i = first; i <= last; ++i) {
        const double value = static_cast<double>(i) * step / parts;
        const double at = std::floor(along({value, value})) + 0.5;
        const bool labelled = i % parts == 0;
        const double length = labelled ? thickness : parts % 2 == 0 && i % (parts / 2) == 0 ? 8 : 5;
        painter.setPen(labelled ? colors.mutedLabel : mixed(colors.canvas, colors.mutedLabel, 0.6));
        painter.drawLine(level() ? QLineF(at, thickness - length, at, thickness)
                                 : QLineF(thickness - length, at, thickness, at));
        if (!labelled || (level() && at < thickness))
            continue;
        painter.setPen(colors.mutedLabel);
        painter.save();
        painter.translate(level() ? QPointF(at + 3, 1) : QPointF(1, at - 3));
        painter.rotate(level() ? 0 : -90);
        painter.drawText(QRectF(0, 0, leastLabelGap, 13), Qt::AlignLeft | Qt::AlignVCenter, gridFigure(value));
        painter.restore();
    }
    if (level()) // the corner belongs to neither
        painter.fillRect(QRect(0, 0, thickness - 1, thickness - 1), palette().color(QPalette::Window));
}

void PatternRuler::paintMarks(QPainter& painter) const
{
    const ViewColors colors = ViewColors::of(m_view.palette());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.snap);
    const PatternGuides& guides = m_aids.guides();
    for (const double value : level() ? guides.x : guides.y) {
        const double at = along({value, value});
        const double end = thickness - 1;
        painter.drawPolygon(level() ? QPolygonF({{at - 5, end - 8}, {at + 5, end - 8}, {at, end}})
                                    : QPolygonF({{end - 8, at - 5}, {end - 8, at + 5}, {end, at}}));
    }
    if (!m_pointer)
        return;
    const double at = along(*m_pointer);
    painter.setPen(QPen(colors.accent, 1.4));
    painter.drawLine(level() ? QLineF(at, 0, at, thickness) : QLineF(0, at, thickness, at));
}

std::vector<double>& PatternRuler::dragged(PatternGuides& guides) const
{
    return level() == m_ownAxis ? guides.x : guides.y;
}

void PatternRuler::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_others = m_aids.guides();
    m_dragging = true;
    m_ownAxis = true;
    std::vector<double>& crossing = dragged(m_others);
    const double at = level() ? event->position().x() : event->position().y();
    const auto grabbed = std::ranges::find_if(crossing, [&](double g) {
        return std::abs(along({g, g}) - at) <= grabReach;
    });
    m_ownAxis = grabbed != crossing.end();
    if (m_ownAxis)
        crossing.erase(grabbed);
}

void PatternRuler::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF inView = event->position() + QPointF(pos());
    const Vec2 layout = m_navigation.transform().toLayout(inView);
    if (!m_dragging) {
        emit pointerMoved(layout);
        return;
    }
    PatternGuides now = m_others;
    const QRect room = m_view.rect().adjusted(thickness, thickness, 0, 0);
    // A new one appears once it has left the ruler; an old one goes when it leaves the view along the ruler.
    const bool upright = level() == m_ownAxis;
    const bool inside = upright ? inView.x() >= room.left() && inView.x() <= room.right()
                                : inView.y() >= room.top() && inView.y() <= room.bottom();
    if (inside)
        dragged(now).push_back(upright ? layout.x() : layout.y());
    m_aids.setGuides(now);
}

void PatternRuler::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_dragging)
        mouseMoveEvent(event);
    m_dragging = false;
}

void paintGuides(QPainter& painter, const PatternGuides& guides, const PatternTransform& transform, QSize size,
                 const ViewColors& colors)
{
    painter.setPen(QPen(mixed(colors.canvas, colors.snap, 0.75), 1));
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const double x : guides.x) {
        const double at = std::floor(transform.toPixels({x, 0}).x()) + 0.5;
        painter.drawLine(QLineF(at, 0, at, size.height()));
    }
    for (const double y : guides.y) {
        const double at = std::floor(transform.toPixels({0, y}).y()) + 0.5;
        painter.drawLine(QLineF(0, at, size.width(), at));
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
}

} // namespace bolster
