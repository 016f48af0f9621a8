#include "TemporaryFile.h"
#include "TestFiles.h"
#include "Unfinished.h"

#include <QDateTime>
#include <QDir>

#include <atomic>
#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace bolster {
namespace {

class TemporaryFileTest : public TestFiles {
protected:
    QStringList hidden() const { return QDir(m_folder.path()).entryList({".*"}, QDir::Files | QDir::Hidden); }

    /// As a program that was killed leaves it.
    QString leftOne() const
    {
        const pid_t child = ::fork();
        if (child == 0) {
            const TemporaryFile file(path("a"));
            ::kill(::getpid(), SIGKILL);
        }
        ::waitpid(child, nullptr, 0);
        return hidden().value(0);
    }

    void makeOld(const QString& name, int days) const
    {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::ReadWrite));
        ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addDays(-days), QFile::FileModificationTime));
    }
};

TEST_F(TemporaryFileTest, TakesThePlaceOfTheOldOneOrGoes)
{
    write("a", "old");
    {
        TemporaryFile file(path("a"));
        EXPECT_TRUE(file.write("new").empty());
    }
    EXPECT_EQ(read("a"), "old");
    TemporaryFile file(path("a"));
    EXPECT_TRUE(file.copyFrom(write("b", "whole")).empty());
    EXPECT_TRUE(file.write(" and more").empty());
    EXPECT_EQ(read("a"), "old");
    EXPECT_TRUE(file.moveIntoPlace().empty());
    EXPECT_EQ(read("a"), "whole and more");
    EXPECT_TRUE(hidden().isEmpty());
    EXPECT_FALSE(TemporaryFile(path("none/a")).problem().empty());
    EXPECT_FALSE(TemporaryFile(path("c")).copyFrom(path("none")).empty());
}

TEST_F(TemporaryFileTest, WhatAKilledProgramHasLeftIsRemoved)
{
    const QString left = leftOne();
    ASSERT_FALSE(left.isEmpty());
    write(left + "-journal", "of SQLite");
    const TemporaryFile used(path("b"));
    write(".bolster-mine", "has another name");
    write("bolster", "too");
    removeLeftTemporaryFiles(m_folder.path());
    EXPECT_EQ(hidden().size(), 2) << hidden().join(' ').toStdString();
    EXPECT_TRUE(QFile::exists(used.path()));
    EXPECT_TRUE(QFile::exists(path(".bolster-mine")));
}

/// A sync service brings them here, and a lock says nothing then.
TEST_F(TemporaryFileTest, ThoseOfOtherMachinesAreLeftAloneForADay)
{
    const QString other = ".bolster-00000000-0123456789abcdef0123456789abcdef";
    write(other, "x");
    removeLeftTemporaryFiles(m_folder.path());
    EXPECT_EQ(hidden().size(), 1);
    makeOld(other, 2);
    removeLeftTemporaryFiles(m_folder.path());
    EXPECT_TRUE(hidden().isEmpty());
}

/// Whoever ends the program while another thread is at work in its folder leaves nothing all the same.
TEST(WorkFolderTest, IsRemovedWhileFilesAreMadeInIt)
{
    for (int time = 0; time < 20; ++time) {
        const WorkFolder folder;
        ASSERT_TRUE(folder.isValid());
        std::atomic<int> made = 0;
        std::jthread maker([&] {
            QFile file;
            do // until the folder is gone
                file.setFileName(folder.filePath(QString::number(made++)));
            while (file.open(QIODevice::WriteOnly) && (file.close(), true));
        });
        while (made < 50)
            std::this_thread::yield();
        removeUnfinished();
        maker.join();
        EXPECT_FALSE(QFileInfo::exists(folder.path())) << made;
    }
}

} // namespace
} // namespace bolster
