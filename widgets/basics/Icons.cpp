#include "Icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include <algorithm>

namespace bolster {

namespace {

QByteArray iconSource(const QString& name)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// SVG knows the colour of the text around it as `currentColor`; Qt's renderer does not.
class PaletteIconEngine : public QIconEngine {
public:
    explicit PaletteIconEngine(const QString& name, const QColor& color = {})
        : m_name(name)
        , m_color(color)
        , m_source(iconSource(name))
    {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        QByteArray svg = m_source;
        QSvgRenderer renderer(svg.replace("currentColor", colorFor(mode).name().toLatin1()));
        renderer.setAspectRatioMode(Qt::KeepAspectRatio);
        renderer.render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        const QString key = QStringLiteral("bolster-%1-%2-%3x%4")
                                .arg(m_name, colorFor(mode).name())
                                .arg(size.width())
                                .arg(size.height());
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap))
            return pixmap;
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        painter.end();
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }

    QIconEngine* clone() const override { return new PaletteIconEngine(*this); }

private:
    QColor colorFor(QIcon::Mode mode) const
    {
        const QPalette palette = QGuiApplication::palette();
        if (mode == QIcon::Disabled)
            return palette.color(QPalette::Disabled, QPalette::ButtonText);
        if (mode == QIcon::Selected)
            return palette.color(QPalette::Active, QPalette::HighlightedText);
        return m_color.isValid() ? m_color : palette.color(QPalette::Active, QPalette::ButtonText);
    }

    QString m_name;
    QColor m_color;
    QByteArray m_source;
};

class SpotEngine : public QIconEngine {
public:
    explicit SpotEngine(const QColor& color)
        : m_color(color)
    {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode, QIcon::State) override
    {
        const double size = 0.62 * std::min(rect.width(), rect.height());
        QRectF spot(0, 0, size, size);
        spot.moveCenter(QRectF(rect).center());
        painter->setRenderHint(QPainter::Antialiasing);
        // Nearly black is not lost on a dark background.
        painter->setPen(QPen(m_color.lightness() < 40 ? QColor(Qt::gray) : m_color.darker(130), 1));
        painter->setBrush(m_color);
        painter->drawRoundedRect(spot, 0.3 * size, 0.3 * size);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new SpotEngine(*this); }

private:
    QColor m_color;
};

} // namespace

QIcon icon(const QString& name)
{
    return QIcon(new PaletteIconEngine(name));
}

QIcon icon(const QString& name, const QColor& color)
{
    return QIcon(new PaletteIconEngine(name, color));
}

QIcon colorSpot(const QColor& color)
{
    return QIcon(new SpotEngine(color));
}

} // namespace bolster
