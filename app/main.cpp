// Bolster: the workbench, or a subcommand without a window.
#include "ApplyPreferences.h"
#include "Ask.h"
#include "CommandLine.h"
#include "Icons.h"
#include "MainWindow.h"
#include "OwnWindow.h"
#include "PortableFolder.h"
#include "PreferenceStore.h"
#include "ProgramPlace.h"
#include "RunLog.h"
#include "Translated.h"
#include "Translations.h"

#include <QApplication>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string_view>

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

const char* const portableOption = "--portable";

/// Takes the option out of the words, for whom it is not there.
bool takePortable(int& argc, char** argv)
{
    if (argc < 2 || std::string_view(argv[1]) != portableOption)
        return false;
    std::rotate(argv + 1, argv + 2, argv + argc);
    argv[--argc] = nullptr;
    return true;
}

/// Who reads a pipe waits for somebody to write. `folder`: of a portable Bolster, or empty.
bolster::Message settingsProblem(const QString& folder)
{
    const QString settings = folder.isEmpty()
                                 ? QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation)
                                 : folder + QStringLiteral("/settings");
    const QString file = settings + QStringLiteral("/Bolster/Bolster.conf");
    const QFileInfo there(file);
    if (!there.exists() || there.isFile())
        return {};
    return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written: it is not an ordinary file"),
            {file.toStdString()}};
}

void prepare(QApplication& application)
{
    QCoreApplication::setApplicationVersion(QStringLiteral(BOLSTER_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("bolster"));
    QApplication::setWindowIcon(bolster::icon(QStringLiteral("bolster")));
    bolster::installTranslations(application, QLocale());
}

/// Without the folder of a portable Bolster nothing begins: work would lie where nobody looks for it.
int refuse(int argc, char** argv, const bolster::Message& problem)
{
    std::fprintf(stderr, "bolster: %s\n", problem.english().c_str());
    if (argc > 1 || !hasDisplay())
        return 1;
    QApplication application(argc, argv);
    prepare(application);
    bolster::tell(nullptr, QMessageBox::Critical, bolster::translated(problem), {});
    QApplication::exec();
    return 1;
}

} // namespace

int main(int argc, char* argv[])
{
    using namespace bolster;
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not become larger is a write that fails, and is said
    std::signal(SIGPIPE, SIG_IGN); // files are written also when nobody reads on what is printed ("| head -1")
    QCoreApplication::setOrganizationName(QStringLiteral("Bolster"));
    QCoreApplication::setApplicationName(QStringLiteral("Bolster"));
    const bool portable = takePortable(argc, argv);
    const QString folder = portableFolder(programFolder(), portable);
    if (!folder.isEmpty())
        if (const Message problem = keepEverythingIn(folder); !problem.empty())
            return refuse(argc, argv, problem);
    if (const std::optional<int> code = runCommandLine(argc, argv))
        return *code;
    if (const Message problem = settingsProblem(folder); !problem.empty())
        return refuse(argc, argv, problem);

    if (!hasDisplay()) {
        std::fputs("bolster: there is no display for the workbench; \"bolster solve\" needs none\n", stderr);
        return 1;
    }
    QApplication application(argc, argv);
    application.setProperty("portable", portable);
    const Preferences preferences = storedPreferences();
    QLocale::setDefault(localeOf(preferences));
    prepare(application);
    beginRunLog(runLogFolder());
    applyLooks(application, preferences);

    MainWindow window;
    QObject::connect(&window, &MainWindow::restartWanted, &openInWindowOfItsOwn);
    const QStringList designs = QCoreApplication::arguments().mid(1);
    if (designs.isEmpty())
        window.greet(); // before the window is there: views that nobody sees are not drawn
    window.show();
    if (designs.isEmpty()) {
        window.recover();
    } else {
        window.open(designs.front());
    }
    for (const QString& another : designs.mid(1))
        openInWindowOfItsOwn(another);
    return QApplication::exec();
}
