#include "TestProject.h"

#include <QDir>

#include <atomic>
#include <thread>

namespace bolster::test {
namespace {

class JournalTest : public TestFiles {
protected:
    /// A journal with this design and its first edits, in a document.
    std::unique_ptr<Journal> work(Document& document, int steps, unsigned seed = 1)
    {
        document.reset(smallDesign());
        auto opened = Journal::create(path("journal"), document.committed());
        EXPECT_EQ(opened.project.problem.english(), "");
        Hands hands(seed);
        for (int i = 0; i < steps; ++i) {
            hands.step(document);
            expectFine(opened.journal->record(document.history(), document.committed()));
        }
        return std::move(opened.journal);
    }

    static void expectSame(const OpenedProject& project, const Document& document)
    {
        ASSERT_EQ(project.problem.english(), "");
        EXPECT_EQ(writeDesign(project.design), writeDesign(document.committed()));
        std::string ignoringFirstTime = historyText(document.history());
        EXPECT_EQ(historyText(project.history).substr(40), ignoringFirstTime.substr(40));
    }

    /// Every version of both, by going there.
    static void expectSameVersions(const OpenedProject& project, Document& document)
    {
        Document again;
        again.reset(project.design, project.history);
        EXPECT_FALSE(again.dirty());
        for (NodeId node = 0; node < document.history().count(); ++node) {
            again.jumpTo(node);
            document.jumpTo(node);
            ASSERT_EQ(again.history().current(), node);
            ASSERT_EQ(writeDesign(again.design()), writeDesign(document.design())) << node;
        }
    }
};

/// SQLite would take it for the end of the log.
TEST_F(JournalTest, AFlippedByteOfItsLogIsNoticedOrCostsTheLastEditAlone)
{
    Document document;
    document.reset(smallDesign());
    const auto opened = Journal::create(path("journal"), document.committed());
    for (int i = 0; i < 10; ++i) {
        const std::string name = "Name " + std::to_string(i);
        document.commit(edits::renameElement(document.design(), ElementId{2}, name));
        expectFine(opened.journal->record(document.history(), document.committed()));
    }
    const std::string bytes = read("journal"), log = read("journal-wal"); // as a killed program leaves them
    ASSERT_GT(log.size(), 20 * 8192U);
    std::mt19937 random(3);
    int noticed = 0;
    for (int round = 0; round < 200; ++round) {
        std::string damaged = log;
        const std::size_t place = round < 32 ? static_cast<std::size_t>(round) : random() % log.size();
        damaged[place] = static_cast<char>(damaged[place] ^ (1 << random() % 8));
        for (const char* name : {"copy", "copy-wal"})
            QFile::remove(path(name));
        write("copy", bytes);
        write("copy-wal", damaged);
        const auto again = Journal::open(path("copy"));
        noticed += again.journal ? 0 : 1;
        if (!again.journal)
            continue;
        EXPECT_GE(again.project.history.count(), document.history().count() - 1) << "byte " << place;
    }
    EXPECT_GT(noticed, 100);
    write("cut", bytes);
    write("cut-wal", log.substr(0, log.size() - 3 * 8192));
    EXPECT_TRUE(Journal::open(path("cut")).journal) << "a power cut is no damage";
}

TEST_F(JournalTest, EverythingComesBackWhenItIsOpenedAgain)
{
    Document document;
    auto journal = work(document, 200);
    document.nameVersion(3, "Before the \"big\" change");
    expectFine(journal->setNames(3, document.history().node(3).name));
    journal.reset();
    const Journal::Opened opened = Journal::open(path("journal"));
    ASSERT_TRUE(opened.journal);
    expectSame(opened.project, document);
    expectSameVersions(opened.project, document);
}

TEST_F(JournalTest, IdsOfOtherBranchesAreKnownAndTheFirstVersionKeepsItsTime)
{
    constexpr std::int64_t began = 1'700'000'000'000;
    Document document;
    const auto created = Journal::create(path("journal"), document.committed(), nullptr, began);
    ASSERT_TRUE(created.journal);
    const ElementId elsewhere{42};
    document.commit({{"Add", {}}, {{elsewhere, nullptr, makeElement(Fabric{})}}});
    document.undo();
    document.commit({{"Add", {}}, {{ElementId{7}, nullptr, makeElement(Fabric{})}}});
    expectFine(created.journal->record(document.history(), document.committed()));
    expectFine(created.journal->save(path("a.bolster")));
    const OpenedProject project = openProject(path("a.bolster"));
    ASSERT_EQ(project.problem.english(), "");
    EXPECT_EQ(largestIdEver(project), elsewhere);
    EXPECT_EQ(project.history.node(0).time.toMSecsSinceEpoch(), began);
}

TEST_F(JournalTest, NamesOfBranchesAreThereAfterUndoAndReopening)
{
    Document document;
    auto journal = work(document, 60);
    const auto name = [&](NodeId node, const char* version, const char* branch) {
        document.nameVersion(node, version);
        document.nameBranch(node, branch);
        expectFine(journal->setNames(node, version, branch));
    };
    name(3, "Shown to the customer", "Leather");
    name(2, "", "Wool");
    name(2, "Final", "Felt"); // each keeps the other one
    name(4, "Both", "Gone");
    name(4, "", "");
    document.undo();
    document.redo();
    expectFine(journal->record(document.history(), document.committed()));
    EXPECT_EQ(document.history().node(3).branch, "Leather");
    expectFine(journal->save(path("a.bolster")));
    journal.reset();
    for (const OpenedProject& project :
         {Journal::open(path("journal")).project, openProject(path("a.bolster"), ProjectCheck::Everything)}) {
        expectSame(project, document);
        EXPECT_EQ(project.history.node(2).branch, "Felt");
        EXPECT_EQ(project.history.node(2).name, "Final");
        EXPECT_EQ(project.history.node(4).branch + project.history.node(4).name, "");
    }
}

TEST_F(JournalTest, TheDifferentRunsOfAProgramContinueEachOther)
{
    Document document;
    work(document, 5);
    Hands hands(7);
    for (int run = 2; run < 6; ++run) {
        Journal::Opened opened = Journal::open(path("journal"));
        ASSERT_TRUE(opened.journal) << opened.project.problem.english();
        expectSame(opened.project, document);
        document.reset(opened.project.design, opened.project.history);
        do
            hands.step(document);
        while (document.history().count() == opened.project.history.count());
        expectFine(opened.journal->record(document.history(), document.committed()));
        opened = {};
        const Journal::Opened again = Journal::open(path("journal"));
        EXPECT_EQ(again.project.nodes.back().run, run);
    }
}

TEST_F(JournalTest, SavedProjectsAreAtRestAndHoldEverything)
{
    Document document;
    auto journal = work(document, 150);
    expectFine(journal->setNames(0, "Start"));
    document.nameVersion(0, "Start");
    expectFine(journal->save(path("a.bolster")));
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).filter("a.bolster").size(), 1);
    EXPECT_EQ(QDir(m_folder.path()).entryList({".bolster*"}, QDir::Files | QDir::Hidden).size(), 0);

    const OpenedProject project = openProject(path("a.bolster"), ProjectCheck::Everything);
    expectSame(project, document);
    EXPECT_EQ(project.saved, document.history().current());
    EXPECT_EQ(journal->base(), project.seal);
    expectSameVersions(project, document);
    EXPECT_TRUE(looksLikeProject(path("a.bolster")));

    // The journal goes on, and the next save replaces the file.
    document.commit(edits::renameElement(document.design(), ElementId{2}, "After saving"));
    expectFine(journal->record(document.history(), document.committed()));
    EXPECT_EQ(journal->base(), openProject(path("a.bolster")).seal);
    expectFine(journal->save(path("a.bolster")));
    expectSame(openProject(path("a.bolster")), document);
}

TEST_F(JournalTest, WhatIsSavedIsOneVersionWhileEditsGoOn)
{
    Document document;
    auto journal = work(document, 2'000);
    Hands hands(5);
    for (int round = 0; round < 5; ++round) {
        std::atomic<bool> saving = true;
        HistoryMark mark;
        std::thread saver([&] {
            expectFine(journal->save(path("a.bolster"), &mark));
            saving = false;
        });
        int during = 0;
        for (int more = 20; saving || more > 0; more -= saving ? 0 : 1, during += saving ? 1 : 0) {
            document.commit(hands.edit(document.design()));
            expectFine(journal->record(document.history(), document.committed()));
        }
        saver.join();
        EXPECT_GT(during, 0);
        const OpenedProject project = openProject(path("a.bolster"), ProjectCheck::Everything);
        ASSERT_EQ(project.problem.english(), "");
        EXPECT_EQ(project.history.mark(), mark);
        const NodeId saved = mark.current;
        EXPECT_EQ(project.history.current(), saved);
        EXPECT_EQ(project.saved, saved);
        EXPECT_GT(project.history.count(), saved);
        EXPECT_EQ(writeDesign(project.design),
                  writeDesign(document.history().designAt(saved, document.committed()).value()));
        EXPECT_EQ(journal->base(), project.seal);
    }
    journal.reset();
    const Journal::Opened again = Journal::open(path("journal"));
    expectSame(again.project, document);
    EXPECT_NE(again.project.saved, again.project.history.current()) << "what came later is unsaved";
}

TEST_F(JournalTest, AProjectIsTakenUpAgainWhereItWasSaved)
{
    Document document;
    auto journal = work(document, 50);
    expectFine(journal->save(path("a.bolster")));
    const std::string saved = read("a.bolster");
    Journal::Opened opened = Journal::begin(path("a.bolster"), path("second"));
    ASSERT_TRUE(opened.journal) << opened.project.problem.english();
    expectSame(opened.project, document);
    EXPECT_EQ(opened.journal->base(), openProject(path("a.bolster")).seal);
    document.commit(edits::renameElement(document.design(), ElementId{2}, "Later"));
    expectFine(opened.journal->record(document.history(), document.committed()));
    EXPECT_EQ(read("a.bolster"), saved);
    opened = {};
    expectSame(Journal::open(path("second")).project, document);
}

TEST_F(JournalTest, OnlyOneProgramCanWorkWithIt)
{
    Document document;
    const auto journal = work(document, 1);
    const Journal::Opened second = Journal::open(path("journal"));
    EXPECT_FALSE(second.journal);
    EXPECT_NE(second.project.problem.english().find("in use by another program"), std::string::npos);
    EXPECT_FALSE(Journal::create(path("journal"), Design()).journal);
    EXPECT_FALSE(openProject(path("journal")).problem.empty()) << "a journal is no project file";
}

TEST_F(JournalTest, KeepsFilesByContent)
{
    Document document;
    auto journal = work(document, 3);
    write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    std::string large;
    for (int i = 0; i < 400'000; ++i)
        large += std::to_string(i) + " 2 3\n";
    write("room.xyz", large);
    const auto add = [&](std::string name, const char* file) {
        expectFine(journal->addAsset(name, path(file)));
        return name;
    };
    EXPECT_EQ(add("chair.obj", "chair.obj"), "chair.obj");
    EXPECT_EQ(add("chair.obj", "chair.obj"), "chair.obj");
    EXPECT_EQ(add("chair.obj", "other.obj"), "chair-2.obj");
    EXPECT_EQ(add("chair.obj", "other.obj"), "chair-2.obj");
    EXPECT_EQ(add("scans/room.xyz", "room.xyz"), "scans/room.xyz");
    for (std::string name : {"", "/chair.obj", "../chair.obj", "a/../../b", ".."})
        EXPECT_FALSE(journal->addAsset(name, path("chair.obj")).empty()) << name;
    expectFine(journal->save(path("a.bolster")));

    const OpenedProject project = openProject(path("a.bolster"), ProjectCheck::Everything);
    ASSERT_EQ(project.problem.english(), "");
    EXPECT_EQ(project.assets.size(), 3u);
    QDir(m_folder.path()).mkdir("out");
    EXPECT_TRUE(extractAssets(project, smallDesign(), path("out")).empty());
    EXPECT_EQ(read("out/chair.obj"), read("chair.obj"));
    EXPECT_EQ(read("out/scans/room.xyz"), large);

    const OpenedDesign opened = openDesignOrProject(path("a.bolster"));
    EXPECT_TRUE(opened.readable);
    EXPECT_EQ(opened.files.meshes.size(), 1u);
    EXPECT_EQ(opened.files.clouds.size(), 1u);
}

TEST_F(JournalTest, CopiesForOthersLeaveOutHistoryOrScans)
{
    Document document;
    auto journal = work(document, 60);
    document.commit(edits::addElement(document.design(), makeElement(Scan{})));
    write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("room.xyz", std::string(2'000'000, ' ') + "1 2 3\n");
    std::string chair = "chair.obj";
    std::string room = "scans/room.xyz";
    expectFine(journal->addAsset(chair, path(chair.c_str())));
    expectFine(journal->addAsset(room, path("room.xyz")));
    document.jumpTo(0);
    expectFine(journal->record(document.history(), document.committed()));

    expectFine(journal->saveCopy(path("short.bolster"), {.withHistory = false, .withScans = true}));
    const OpenedProject shortened = openProject(path("short.bolster"), ProjectCheck::Everything);
    ASSERT_EQ(shortened.problem.english(), "");
    EXPECT_EQ(shortened.history.count(), 1);
    EXPECT_EQ(writeDesign(shortened.design), writeDesign(document.committed()));
    EXPECT_EQ(shortened.assets.size(), 2u);

    expectFine(journal->saveCopy(path("small.bolster"), {.withHistory = true, .withScans = false}));
    const OpenedProject small = openProject(path("small.bolster"), ProjectCheck::Everything);
    expectSame(small, document);
    EXPECT_EQ(small.assets.size(), 1u);
    EXPECT_LT(QFileInfo(path("small.bolster")).size(), 1'000'000);

    expectFine(journal->saveCopy(path("both.bolster"), {.withHistory = false, .withScans = false}));
    EXPECT_EQ(openProject(path("both.bolster"), ProjectCheck::Everything).assets.size(), 1u);
    EXPECT_FALSE(journal->base()) << "a copy is not a save";
    expectFine(journal->saveCopy(path("all.bolster"), {}));
    EXPECT_EQ(openProject(path("all.bolster"), ProjectCheck::Everything).assets.size(), 2u);
}

TEST_F(JournalTest, SaysWhyItCannotSave)
{
    Document document;
    auto journal = work(document, 3);
    EXPECT_FALSE(journal->save(path("none/a.bolster")).empty());
    EXPECT_FALSE(journal->save(m_folder.path()).empty());
    EXPECT_EQ(QDir(m_folder.path()).entryList({".bolster*"}, QDir::Files | QDir::Hidden).size(), 0);
    expectFine(journal->save(path("a.bolster")));
}

TEST_F(JournalTest, PicturesMayGetLost)
{
    Document document;
    auto journal = work(document, 3);
    expectFine(journal->setThumbnail(1, "a picture"));
    expectFine(journal->save(path("a.bolster")));
    EXPECT_EQ(journal->thumbnail(1), "a picture");
    EXPECT_EQ(journal->thumbnail(2), "");
    expectSame(openProject(path("a.bolster")), document);
}

TEST_F(JournalTest, WhatIsNoProjectIsRefusedWithAReason)
{
    EXPECT_EQ(openProject(path("none")).problem.english(),
              "there is no file \"" + path("none").toStdString() + "\"");
    for (const std::string& bytes : {std::string(), std::string("hello"), std::string(8192, '\0')})
        EXPECT_NE(openProject(write("x", bytes)).problem.english().find("no Bolster project"), std::string::npos);
    EXPECT_FALSE(openProject(m_folder.path()).problem.empty());

    Document document;
    expectFine(work(document, 3)->save(path("a.bolster")));
    std::string newer = read("a.bolster");
    newer[63] = 2;
    const std::string why = openProject(write("newer.bolster", newer)).problem.english();
    EXPECT_NE(why.find("newer Bolster (version 2"), std::string::npos) << why;
    EXPECT_EQ(read("newer.bolster"), newer);
    std::string cut = read("a.bolster");
    cut.resize(cut.size() - 8192);
    EXPECT_FALSE(openProject(write("cut.bolster", cut)).problem.empty());
}

TEST_F(JournalTest, RefusesAnEditThatWouldNotComeBack)
{
    EXPECT_FALSE(
        Journal::create(path("nan"), Design().with({{}, {{settingsId, nullptr, makeElement(Settings{NAN})}}}))
            .journal);
    EXPECT_FALSE(QFileInfo::exists(path("nan")));
}

} // namespace
} // namespace bolster::test
