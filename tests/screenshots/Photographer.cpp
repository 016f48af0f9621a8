#include "Photographer.h"

#include <QImage>
#include <QPixmap>
#include <QScreen>

namespace bolster {
namespace {

/// With fewer shades: nobody sees it, and the files are half as large.
QImage plain(QImage picture)
{
    picture = picture.convertToFormat(QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x)
            line[x] = (line[x] & 0xfffcfcfcU) | ((line[x] >> 6) & 0x00030303U);
    }
    return picture;
}

} // namespace

void Photographer::take(const QString& name)
{
    waitFor([this] { return m_window.solver().upToDate(); }, 10000);
    waitFor([this] { return m_window.solver().status().resting; }, m_window.solver().surface() ? 20000 : 0);
    waitFor([] { return false; }, 2500); // the fine picture comes when nothing moves any more
    take(name, m_window.geometry());
}

void Photographer::take(const QString& name, const QRect& place)
{
    const QPixmap picture = m_window.screen()->grabWindow(0, place.x(), place.y(), place.width(), place.height());
    m_good = plain(picture.toImage()).save(m_folder.filePath(m_group + "-" + name + ".png")) && m_good;
}

} // namespace bolster
