#include "Crosshair.h"

#include "ViewColors.h"

#include <QPainter>

namespace bolster {

namespace {

// Pixels.
constexpr int crossReach = 16;
constexpr double crossGap = 4.5;
constexpr double ring = 8;

} // namespace

Crosshair::Crosshair(QWidget* parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    resize(2 * crossReach + 1, 2 * crossReach + 1);
    hide();
}

void Crosshair::showAt(const std::optional<QPointF>& pixel, bool faint)
{
    if (!pixel) {
        hide();
        return;
    }
    m_faint = faint;
    const QPoint place(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
    m_rest = *pixel - place;
    move(place - QPoint(crossReach, crossReach));
    show();
    update();
}

void Crosshair::paintEvent(QPaintEvent*)
{
    const ViewColors colors = ViewColors::of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(m_faint ? 0.45 : 1);
    painter.translate(QPointF(crossReach, crossReach) + m_rest);
    const auto draw = [&](const QColor& color, double width) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
        painter.drawEllipse(QPointF(), ring, ring);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(crossGap * way, (crossReach - 1) * way);
    };
    draw(QColor(255, 255, 255, 200), 3.4);
    draw(colors.accent, 1.6);
}

} // namespace bolster
