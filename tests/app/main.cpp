// The real window, with settings and unsaved work of its own.
#include "ProgramThatDies.h"
#include "WatchedApplication.h"

#include <QClipboard>
#include <QDir>
#include <QSettings>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace {

/// Each test finds the program as if nobody had used it before.
class FreshHome : public testing::EmptyTestEventListener {
public:
    explicit FreshHome(QString home)
        : m_home(std::move(home))
    {}

    void OnTestStart(const testing::TestInfo& /*test*/) override
    {
        QSettings().clear();
        QDir(m_home + QStringLiteral("/data")).removeRecursively(); // unsaved work
        QGuiApplication::clipboard()->clear();
    }

private:
    QString m_home;
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
    testing::UnitTest::GetInstance()->listeners().Append(new FreshHome(home.path())); // which deletes it
    return dying.isEmpty() ? RUN_ALL_TESTS() : bolster::ProgramThatDies::workAndDie(dying);
}
