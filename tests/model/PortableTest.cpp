// Where a portable Bolster keeps things, and where a program finds what is shipped with it.
#include "TestFiles.h"

#include "PortableFolder.h"
#include "ProgramPlace.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <array>

namespace bolster {
namespace {

/// What keepEverythingIn changes of this process is as it was afterwards.
class Portable : public TestFiles {
protected:
    Portable()
    {
        for (std::size_t i = 0; i < variables.size(); ++i)
            m_before[i] = qEnvironmentVariableIsSet(variables[i]) ? qgetenv(variables[i]) : QByteArray("-");
    }
    ~Portable() override
    {
        for (std::size_t i = 0; i < variables.size(); ++i)
            if (m_before[i] == "-")
                qunsetenv(variables[i]);
            else
                qputenv(variables[i], m_before[i]);
    }

    std::filesystem::path folder(const QString& name) const
    {
        QDir().mkpath(path(name));
        return path(name).toStdString();
    }

    static constexpr std::array variables = {"XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"};
    std::array<QByteArray, 3> m_before;
};

TEST_F(Portable, IsAskedForOrMarkedByAFileBesideTheProgramOrItsBin)
{
    const auto bin = folder("stick/bin");
    EXPECT_EQ(portableFolder(bin, false), "");
    EXPECT_EQ(portableFolder(bin, true), path("stick/bolster-settings"));
    write("stick/portable", "");
    EXPECT_EQ(portableFolder(bin, false), path("stick/bolster-settings"));
    QFile::remove(path("stick/portable"));
    write("stick/bin/portable", "");
    EXPECT_EQ(portableFolder(bin, false), path("stick/bolster-settings"));

    const auto plain = folder("here");
    EXPECT_EQ(portableFolder(plain, false), "");
    QDir(path("here")).mkdir("portable");
    EXPECT_EQ(portableFolder(plain, false), "") << "a folder is no mark";
    EXPECT_EQ(portableFolder(plain, true), path("here/bolster-settings"));
    EXPECT_EQ(portableFolder({}, true), "") << "a program that does not know where it is";
}

TEST_F(Portable, SettingsAndWorkAreBesideTheProgram)
{
    const QString kept = path("stick/bolster-settings");
    ASSERT_EQ(keepEverythingIn(kept).english(), "");
    for (const auto place : {QStandardPaths::AppLocalDataLocation, QStandardPaths::GenericCacheLocation})
        EXPECT_TRUE(QStandardPaths::writableLocation(place).startsWith(kept + '/'));
    const QString name = "PortableTest";
    QSettings settings(name, name);
    EXPECT_TRUE(settings.fileName().startsWith(kept + '/')) << settings.fileName().toStdString();
    settings.setValue("theme", 1);
    settings.sync();
    EXPECT_TRUE(QFileInfo(settings.fileName()).size() > 0);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QDir::homePath() + "/.config");
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, QDir::homePath() + "/.config");
}

TEST_F(Portable, WhereNothingCanBeWrittenItSaysSoAndChangesNothing)
{
    write("file", "precious");
    const QByteArray before = qgetenv("XDG_DATA_HOME");
    const std::string problem = keepEverythingIn(path("file/bolster-settings")).english();
    EXPECT_NE(problem.find(path("file/bolster-settings").toStdString()), std::string::npos) << problem;
    EXPECT_NE(problem.find("copy its folder"), std::string::npos) << problem;
    EXPECT_EQ(qgetenv("XDG_DATA_HOME"), before);
    EXPECT_EQ(read("file"), "precious");
}

TEST_F(Portable, OnlyWhatWasNotInstalledLooksIntoItsBuild)
{
    folder("build/app/cli");
    write("build/CMakeCache.txt", "");
    EXPECT_EQ(buildAround(folder("build/app/cli")), folder("build"));
    EXPECT_EQ(buildAround(folder("build/a/b/c/d/e")), "") << "too far";
    EXPECT_EQ(buildAround(folder("prefix/bin")), "");
    EXPECT_EQ(buildAround({}), "");
    EXPECT_FALSE(programFolder().empty());
    EXPECT_EQ(shippedFile("no such program", "app"), "");
}

} // namespace
} // namespace bolster
