#include "PictureStrip.h"

#include "ViewColors.h"

#include <QPainter>

#include <algorithm>

namespace bolster {

namespace {

// Pixels.
constexpr int stripHeight = 128;
constexpr int stripPadding = 6;
constexpr int stripGap = 10;
constexpr int leastSide = 60;
constexpr double cornerRadius = 4;

/// Grey without a tint: what lies on it is seen in its own colours.
QColor ground(const QPalette& palette)
{
    return ViewColors::of(palette).dark ? QColor(0x48, 0x48, 0x48) : QColor(0xe2, 0xe2, 0xe2);
}

} // namespace

PictureStrip::PictureStrip(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMinimumWidth(2 * leastSide + stripGap + 2 * stripPadding);
}

void PictureStrip::setPictures(std::vector<QImage> pictures)
{
    if (std::ranges::equal(pictures, m_pictures, {}, &QImage::cacheKey, &QImage::cacheKey))
        return;
    m_pictures = std::move(pictures);
    update();
}

QSize PictureStrip::sizeHint() const
{
    return {2 * stripHeight, stripHeight};
}

void PictureStrip::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground(palette()));
    painter.drawRoundedRect(rect(), cornerRadius, cornerRadius);
    const int count = static_cast<int>(m_pictures.size());
    if (count == 0)
        return;
    const int side =
        std::min(height() - 2 * stripPadding, (width() - 2 * stripPadding - (count - 1) * stripGap) / count);
    QPoint at((width() - count * side - (count - 1) * stripGap) / 2, (height() - side) / 2);
    for (const QImage& picture : m_pictures) {
        if (!picture.isNull()) {
            // A painter would skip pixels of what is more than twice as fine.
            const QSize fine = (QSizeF(side, side) * devicePixelRatioF()).toSize();
            QImage fitting = picture.scaled(fine, Qt::KeepAspectRatio, Qt::SmoothTransformation);
            fitting.setDevicePixelRatio(devicePixelRatioF());
            painter.drawImage(at, fitting);
        }
        at.rx() += side + stripGap;
    }
}

} // namespace bolster
