#include "Photographer.h"

#include "Theme.h"
#include "Translations.h"

#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>

#include <cstdio>

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

int photograph(int argc, char* argv[], const char* words, const std::function<int(const QStringList&)>& play)
{
    QStandardPaths::setTestModeEnabled(true); // the user's own settings and unsaved work are none of ours
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("BolsterScreenshots");
    QCoreApplication::setApplicationName("Bolster");
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application, QLocale(QLocale::English)); // "1 warning"
    const QStringList given = application.arguments().mid(1);
    if (given.size() != QString(words).split(u' ').size()) {
        std::fprintf(stderr, "usage: %s %s\n", argv[0], words);
        return 2;
    }
    QSettings().clear(); // a newcomer has none
    QLocale::setDefault(QLocale::c());
    applyTheme(application, Theme::Light);
    return play(given);
}

} // namespace bolster
