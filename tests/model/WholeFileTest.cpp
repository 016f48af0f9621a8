#include "WholeFile.h"
#include "TestFiles.h"

#include <QDir>
#include <QFileInfo>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bolster {
namespace {

class WholeFileTest : public TestFiles {
protected:
    int fileCount() const
    {
        return static_cast<int>(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System).size());
    }
};

TEST_F(WholeFileTest, ReplacesAndReads)
{
    EXPECT_TRUE(replaceWholeFile(path("a.txt"), "first, longer").empty());
    EXPECT_TRUE(replaceWholeFile(path("a.txt"), "second").empty());
    EXPECT_EQ(readWholeFile(path("a.txt"), 100).bytes, "second");
    EXPECT_EQ(fileCount(), 1); // no temporary file stays
}

/// Whoever was faster keeps what he wrote.
TEST_F(WholeFileTest, ANewFileReplacesNothing)
{
    EXPECT_TRUE(createWholeFile(path("new.txt"), "mine").empty());
    EXPECT_EQ(read("new.txt"), "mine");
    const Message problem = createWholeFile(path("new.txt"), "other");
    EXPECT_NE(problem.english().find("is there already"), std::string::npos) << problem.english();
    EXPECT_EQ(read("new.txt"), "mine");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(WholeFileTest, RefusesToReadWhatIsNoFileOrTooLarge)
{
    write("a.txt", "123456");
    EXPECT_TRUE(readWholeFile(path("a.txt"), 6).problem.empty());
    EXPECT_NE(readWholeFile(path("a.txt"), 5).problem.english().find("too large"), std::string::npos);
    EXPECT_NE(readWholeFile(path("none"), 5).problem.english().find("there is no file"), std::string::npos);
    EXPECT_NE(readWholeFile(m_folder.path(), 5).problem.english().find("folder"), std::string::npos);
    ASSERT_EQ(::mkfifo(path("pipe").toUtf8().constData(), 0600), 0);
    EXPECT_FALSE(readWholeFile(path("pipe"), 5).problem.empty()); // and it does not wait
}

TEST_F(WholeFileTest, SaysWhatPreventsWriting)
{
    EXPECT_NE(replaceWholeFile(path("none/a.txt"), "x").english().find("there is no folder"), std::string::npos);
    EXPECT_NE(replaceWholeFile(m_folder.path(), "x").english().find("it is a folder"), std::string::npos);
    if (QFileInfo::exists("/dev/full")) {
        EXPECT_NE(replaceWholeFile("/dev/full", "x").english().find("disk is full"), std::string::npos);
    }
    if (::geteuid() != 0) { // root may write everywhere
        write("locked.txt", "old");
        QFile::setPermissions(path("locked.txt"), QFile::ReadOwner);
        EXPECT_NE(replaceWholeFile(path("locked.txt"), "x").english().find("write-protected"), std::string::npos);
        EXPECT_EQ(read("locked.txt"), "old");
    }
}

TEST_F(WholeFileTest, AFailureInTheMiddleKeepsTheOldFile)
{
    write("a.txt", "old");
    const pid_t child = ::fork();
    if (child == 0) { // only there, files may not grow beyond 4096 bytes
        const rlimit limit = {4096, 4096};
        std::signal(SIGXFSZ, SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::_exit(replaceWholeFile(path("a.txt"), std::string(10'000, 'x')).empty() ? 1 : 0);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(read("a.txt"), "old");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(WholeFileTest, KeepsPermissionsAndLinks)
{
    write("real.txt", "old");
    ASSERT_EQ(::chmod(path("real.txt").toUtf8().constData(), 0640), 0);
    ASSERT_TRUE(QFile::link("real.txt", path("link.txt")));
    EXPECT_TRUE(replaceWholeFile(path("link.txt"), "new").empty());
    EXPECT_EQ(read("real.txt"), "new");
    EXPECT_TRUE(QFileInfo(path("link.txt")).isSymLink());
    struct stat info = {};
    ASSERT_EQ(::stat(path("real.txt").toUtf8().constData(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST_F(WholeFileTest, ALinkToWhatIsNotThereYetLeadsThere)
{
    ASSERT_TRUE(QFile::link("later.txt", path("link.txt")));
    EXPECT_EQ(fileKey(path("link.txt")), fileKey(path("later.txt")));
    EXPECT_TRUE(replaceWholeFile(path("link.txt"), "new").empty());
    EXPECT_EQ(read("later.txt"), "new");
    EXPECT_TRUE(QFileInfo(path("link.txt")).isSymLink());
    ASSERT_TRUE(QFile::link("loop.txt", path("loop.txt")));
    EXPECT_FALSE(replaceWholeFile(path("loop.txt"), "new").empty());
    EXPECT_TRUE(QFileInfo(path("loop.txt")).isSymLink());
}

TEST_F(WholeFileTest, AllNamesOfAFileHaveOneKey)
{
    write("real.txt", "old");
    write("other.txt", "old");
    ASSERT_TRUE(QFile::link("real.txt", path("link.txt")));
    ASSERT_EQ(::link(path("real.txt").toUtf8().constData(), path("second.txt").toUtf8().constData()), 0);
    EXPECT_EQ(fileKey(path("link.txt")), fileKey(path("real.txt")));
    EXPECT_EQ(fileKey(path("second.txt")), fileKey(path("real.txt")));
    EXPECT_NE(fileKey(path("other.txt")), fileKey(path("real.txt")));
    EXPECT_NE(fileKey(path("none.txt")), fileKey(path("neither.txt")));
}

TEST_F(WholeFileTest, WritesToDevicesDirectly)
{
    EXPECT_TRUE(replaceWholeFile("/dev/null", "x").empty());
    struct stat info = {};
    ASSERT_EQ(::stat("/dev/null", &info), 0);
    EXPECT_TRUE(S_ISCHR(info.st_mode)); // not replaced by a file
}

} // namespace
} // namespace bolster
