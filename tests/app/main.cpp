// The real window, with settings and unsaved work of its own.
#include "ProgramThatDies.h"
#include "WatchedApplication.h"

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace {

/// Each test begins as at the first start: what one before has left in the settings or among unsaved work is gone.
class FirstStart : public testing::EmptyTestEventListener {
public:
    explicit FirstStart(const QTemporaryDir& home)
        : m_home(home)
    {}
    void OnTestStart(const testing::TestInfo&) override
    {
        QSettings().clear();
        for (const char* const place : {"config", "data"})
            QDir(m_home.filePath(place)).removeRecursively();
    }

private:
    const QTemporaryDir& m_home;
};

} // namespace

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
    if (!dying.isEmpty())
        return bolster::ProgramThatDies::workAndDie(dying);
    testing::UnitTest::GetInstance()->listeners().Append(new FirstStart(home)); // which owns it
    return RUN_ALL_TESTS();
}
