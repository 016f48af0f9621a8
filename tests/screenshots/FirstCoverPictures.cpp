// Plays the path of a newcomer in the real window and writes a picture of each step:
//   bolster_first_cover FOLDER
#include "FirstCover.h"
#include "MainWindow.h"
#include "Theme.h"
#include "Translations.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>

#include <cstdio>

namespace bolster {
namespace {

template <class Condition>
void waitFor(Condition condition, int mostMs)
{
    QElapsedTimer time;
    time.start();
    while (!condition() && time.elapsed() < mostMs)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
}

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

class Photographer {
public:
    Photographer(MainWindow& window, const QDir& folder)
        : m_window(window)
        , m_folder(folder)
    {}

    void take(const QString& name)
    {
        waitFor([this] { return m_window.solver().upToDate(); }, 10000);
        waitFor([this] { return m_window.solver().status().resting; }, m_window.solver().surface() ? 20000 : 0);
        waitFor([] { return false; }, 2500); // the fine picture comes when nothing moves any more
        const QRect place = m_window.geometry();
        const QPixmap picture =
            m_window.screen()->grabWindow(0, place.x(), place.y(), place.width(), place.height());
        m_good = plain(picture.toImage()).save(m_folder.filePath(QStringLiteral("first-cover-%1.png").arg(name))) &&
                 m_good;
    }

    bool good() const { return m_good; }

private:
    MainWindow& m_window;
    QDir m_folder;
    bool m_good = true;
};

int run(const QDir& folder)
{
    MainWindow window;
    window.resize(1120, 700);
    window.show();
    waitFor([] { return false; }, 1000);
    window.activateWindow();
    Designer designer(window);
    Photographer camera(window, folder);
    sewFirstCover(designer, [&](const QString& name) { camera.take(name); });
    std::printf("%d clicks\n", designer.clicks());
    window.document().markSaved();
    return camera.good() ? 0 : 1;
}

} // namespace
} // namespace bolster

int main(int argc, char* argv[])
{
    QStandardPaths::setTestModeEnabled(true); // the user's own settings and unsaved work are none of ours
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("BolsterScreenshots");
    QCoreApplication::setApplicationName("Bolster");
    bolster::installTranslations(application, QLocale(QLocale::English)); // "1 warning"
    if (application.arguments().size() != 2) {
        std::fputs("usage: bolster_first_cover FOLDER\n", stderr);
        return 2;
    }
    QSettings().clear(); // a newcomer has none
    QLocale::setDefault(QLocale::c());
    bolster::applyTheme(application, bolster::Theme::Light);
    return bolster::run(QDir(application.arguments().at(1)));
}
