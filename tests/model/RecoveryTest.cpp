#include "Recovery.h"
#include "DesignFile.h"
#include "TestFiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QStandardPaths>

#include <functional>
#include <sys/wait.h>
#include <unistd.h>

namespace bolster {
namespace {

Edit setFabric(const Design& design, const std::string& name)
{
    return {{"Name it", {}}, {{ElementId{1}, design.element(ElementId{1}), makeElement(Fabric{.name = name})}}};
}

class RecoveryTest : public TestFiles {
protected:
    RecoveryTest() { QDir(folder()).removeRecursively(); }
    ~RecoveryTest() override { QDir(folder()).removeRecursively(); }

    static QString folder()
    {
        return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery";
    }
    static qsizetype copies() { return QDir(folder()).entryList({"*.json"}).size(); }

    static bool waitFor(const std::function<bool()>& done)
    {
        QElapsedTimer clock;
        for (clock.start(); clock.elapsed() < 20'000 && !done();)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 20);
        return done();
    }

    /// The text of the only copy's fabric, or "".
    static std::string copiedName()
    {
        const QFileInfoList list = QDir(folder()).entryInfoList({"*.json"});
        const OpenedDesign opened = list.size() == 1 ? openDesign(list[0].filePath()) : OpenedDesign{};
        const Fabric* fabric = opened.design.find<Fabric>(ElementId{1});
        return fabric ? fabric->name : "";
    }

    /// What a program leaves that dies with unsaved work.
    void crash(const std::string& name, const QString& original)
    {
        const pid_t child = ::fork();
        if (child == 0) {
            Document document;
            auto* recovery = new Recovery(document);
            recovery->setOriginal(original);
            document.commit(setFabric(document.design(), name));
            const bool written = waitFor([] { return copies() == 1; });
            ::_exit(written ? 0 : 1);
        }
        int status = -1;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_EQ(status, 0);
    }
};

TEST_F(RecoveryTest, CopiesUnsavedWorkAndRemovesItWhenSaved)
{
    Document document;
    Recovery recovery(document);
    EXPECT_EQ(copies(), 0);
    document.commit(setFabric(document.design(), "Leather"));
    EXPECT_TRUE(waitFor([] { return copiedName() == "Leather"; }));
    document.commit(setFabric(document.design(), "Wool"));
    EXPECT_TRUE(waitFor([] { return copiedName() == "Wool"; }));
    EXPECT_TRUE(Recovery::orphans().empty()); // its owner runs
    document.markSaved();
    EXPECT_TRUE(waitFor([] { return copies() == 0; }));
}

TEST_F(RecoveryTest, SteadyWorkIsCopiedToo)
{
    Document document;
    Recovery recovery(document);
    int edits = 0;
    EXPECT_TRUE(waitFor([&] {
        document.commit(setFabric(document.design(), std::to_string(++edits)));
        return copies() == 1;
    }));
}

TEST_F(RecoveryTest, LeavesTheLastStateWhenNobodyDecided)
{
    {
        Document document;
        Recovery recovery(document);
        document.commit(setFabric(document.design(), "Leather"));
    }
    EXPECT_EQ(copiedName(), "Leather");
    ASSERT_EQ(Recovery::orphans().size(), 1);
    EXPECT_TRUE(Recovery::orphans()[0].original.isEmpty());
    Recovery::discard(Recovery::orphans()[0]);
    EXPECT_EQ(copies(), 0);
    EXPECT_TRUE(QDir(folder()).isEmpty());
}

TEST_F(RecoveryTest, GoesWhenTheUserDecidesSo)
{
    {
        Document document;
        Recovery recovery(document);
        document.commit(setFabric(document.design(), "Leather"));
        EXPECT_TRUE(waitFor([] { return copies() == 1; }));
        document.commit(setFabric(document.design(), "Wool"));
        recovery.discard();
    }
    EXPECT_EQ(copies(), 0);
}

TEST_F(RecoveryTest, OffersTheWorkOfACrashedProgramAndTakesItOver)
{
    crash("Leather", path("seat.json"));
    const QList<Recovery::Orphan> orphans = Recovery::orphans();
    ASSERT_EQ(orphans.size(), 1);
    EXPECT_EQ(orphans[0].original, path("seat.json"));
    EXPECT_EQ(orphans[0].frameFolder(), m_folder.path());
    EXPECT_LT(orphans[0].when.secsTo(QDateTime::currentDateTime()), 60);

    Document document;
    Recovery recovery(document);
    const OpenedDesign opened = openDesign(orphans[0].file, orphans[0].frameFolder());
    ASSERT_TRUE(opened.readable);
    document.reset(opened.design);
    document.markUnsaved();
    ASSERT_TRUE(recovery.adopt(orphans[0]));
    EXPECT_EQ(copiedName(), "Leather"); // never without a copy
    EXPECT_TRUE(Recovery::orphans().empty());
    {
        Document otherDocument;
        Recovery other(otherDocument);
        EXPECT_FALSE(other.adopt(orphans[0]));
        Recovery::discard(orphans[0]);
        EXPECT_EQ(copies(), 1); // another program cannot remove what is in use
    }
    document.commit(setFabric(document.design(), "Wool"));
    EXPECT_TRUE(waitFor([] { return copiedName() == "Wool"; }));
    document.markSaved();
    EXPECT_TRUE(waitFor([] { return copies() == 0; }));
}

TEST_F(RecoveryTest, AClosedDocumentLeavesNothing)
{
    {
        Document document;
        Recovery recovery(document);
        document.commit(setFabric(document.design(), "Leather"));
        EXPECT_TRUE(waitFor([] { return copies() == 1; }));
        document.markSaved();
    }
    EXPECT_TRUE(QDir(folder()).isEmpty());
}

TEST_F(RecoveryTest, SaysWhenItCannotProtect)
{
    ASSERT_TRUE(QDir().mkpath(QFileInfo(folder()).path()));
    QFile obstacle(folder()); // a file where the folder should be
    ASSERT_TRUE(obstacle.open(QIODevice::WriteOnly));
    obstacle.close();
    Document document;
    Recovery recovery(document);
    int failures = 0;
    QObject::connect(&recovery, &Recovery::failed, [&](const Message& why) {
        EXPECT_FALSE(why.empty());
        ++failures;
    });
    document.commit(setFabric(document.design(), "Leather"));
    EXPECT_TRUE(waitFor([&] { return failures > 0; }));
    obstacle.remove();
}

} // namespace
} // namespace bolster
