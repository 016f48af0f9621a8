// Plays the path of a newcomer in the real window and writes a picture of each step:
//   bolster_first_cover FOLDER
#include "FirstCover.h"
#include "MainWindow.h"
#include "Photographer.h"

#include <QDir>

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
    return bolster::photograph(argc, argv, "FOLDER",
                               [](const QStringList& given) { return bolster::run(QDir(given.at(0))); });
}
