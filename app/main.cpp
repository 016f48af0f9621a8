// Bolster: the workbench, or a subcommand without a window.
#include "ApplyPreferences.h"
#include "CommandLine.h"
#include "Icons.h"
#include "MainWindow.h"
#include "PreferenceStore.h"
#include "Translations.h"

#include <QApplication>
#include <QFileInfo>
#include <QLocale>
#include <QProcess>

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

/// In a program of its own: whatever happens to one design, the others go on.
void openInWindowOfItsOwn(const QString& path)
{
    QProcess::startDetached(QCoreApplication::applicationFilePath(), {QFileInfo(path).absoluteFilePath()});
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
    const Preferences preferences = storedPreferences();
    QLocale::setDefault(localeOf(preferences));
    installTranslations(application, QLocale());
    applyLooks(application, preferences);

    MainWindow window;
    window.show();
    const QStringList designs = QCoreApplication::arguments().mid(1);
    if (designs.isEmpty())
        window.recover();
    else
        window.open(designs.front());
    for (const QString& another : designs.mid(1))
        openInWindowOfItsOwn(another);
    return QApplication::exec();
}
