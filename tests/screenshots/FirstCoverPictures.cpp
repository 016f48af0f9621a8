// Plays the path of a newcomer in the real window and writes a picture of each step:
//   bolster_first_cover FOLDER
#include "FirstCover.h"
#include "MainWindow.h"
#include "Photographer.h"
#include "Theme.h"
#include "Translations.h"

#include <QApplication>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>

#include <cstdio>

namespace bolster {
namespace {

int run(const QDir& folder)
{
    MainWindow window;
    window.resize(1120, 700);
    window.show();
    waitFor([] { return false; }, 1000);
    window.activateWindow();
    Designer designer(window);
    Photographer camera(window, folder, QStringLiteral("first-cover"));
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
