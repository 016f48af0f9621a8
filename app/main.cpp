// Bolster: the workbench, or a subcommand without a window.
#include "CommandLine.h"
#include "Icons.h"
#include "MainWindow.h"
#include "OwnWindow.h"
#include "RunLog.h"
#include "Theme.h"
#include "Translations.h"

#include <QApplication>
#include <QLocale>

#include <cstdio>

namespace {

/// Qt would abort the program.
bool hasDisplay()
{
#ifdef Q_OS_LINUX
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

} // namespace

int main(int argc, char* argv[])
{
    using namespace bolster;
    QCoreApplication::setOrganizationName(QStringLiteral("Bolster"));
    QCoreApplication::setApplicationName(QStringLiteral("Bolster"));
    if (const std::optional<int> code = runCommandLine(argc, argv))
        return *code;

    if (!hasDisplay()) {
        std::fputs("bolster: there is no display for the workbench; \"bolster solve\" needs none\n", stderr);
        return 1;
    }
    QApplication application(argc, argv);
    QCoreApplication::setApplicationVersion(QStringLiteral(BOLSTER_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("bolster"));
    QApplication::setWindowIcon(icon(QStringLiteral("bolster")));
    beginRunLog(runLogFolder());
    installTranslations(application, QLocale());
    applyTheme(application, storedTheme());

    MainWindow window;
    window.show();
    const QStringList designs = QCoreApplication::arguments().mid(1);
    if (designs.isEmpty()) {
        window.greet();
        window.recover();
    } else {
        window.open(designs.front());
    }
    for (const QString& another : designs.mid(1))
        openInWindowOfItsOwn(another);
    return QApplication::exec();
}
