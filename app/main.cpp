// Bolster: the workbench, or a subcommand without a window.
#include "CommandLine.h"
#include "Icons.h"
#include "MainWindow.h"
#include "Theme.h"
#include "Translations.h"

#include <QApplication>
#include <QLocale>

int main(int argc, char* argv[])
{
    using namespace bolster;
    if (const std::optional<int> code = runCommandLine(argc, argv))
        return *code;

    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Bolster"));
    QCoreApplication::setApplicationName(QStringLiteral("Bolster"));
    QCoreApplication::setApplicationVersion(QStringLiteral(BOLSTER_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("bolster"));
    QApplication::setWindowIcon(icon(QStringLiteral("bolster")));
    installTranslations(application, QLocale());
    applyTheme(application, storedTheme());

    MainWindow window;
    window.show();
    window.offerRecovery();
    if (const QStringList arguments = QCoreApplication::arguments(); arguments.size() > 1)
        window.open(arguments.at(1));
    return QApplication::exec();
}
