// The real window, with settings and unsaved work of its own.
#include "ProgramThatDies.h"
#include "WatchedApplication.h"

#include <QStandardPaths>
#include <QTemporaryDir>

#include <gtest/gtest.h>

int main(int argc, char* argv[])
{
    // On the screen that is there (ctest runs under Xvfb); without one, on none.
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QTemporaryDir home;
    const QStringList dying = bolster::ProgramThatDies::wanted();
    if (dying.isEmpty()) { // else in the home of the program that waits for it
        qputenv("XDG_CONFIG_HOME", home.filePath("config").toLocal8Bit());
        qputenv("XDG_DATA_HOME", home.filePath("data").toLocal8Bit());
    }
    testing::InitGoogleTest(&argc, argv);
    if (GTEST_FLAG_GET(list_tests))
        return RUN_ALL_TESTS(); // at build time, when there may be no screen
    bolster::WatchedApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("BolsterTests"));
    QCoreApplication::setApplicationName(QStringLiteral("Bolster"));
    return dying.isEmpty() ? RUN_ALL_TESTS() : bolster::ProgramThatDies::workAndDie(dying);
}
