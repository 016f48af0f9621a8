// Whatever the user does, and whenever the program is closed and opened again: the design is what its replay says.
#include "DesignHash.h"
#include "TestProject.h"

namespace bolster::test {
namespace {

/// From nothing, by the edits of a history that was never stored.
Hash replayed(const Design& start, const History& history)
{
    Design design = start;
    for (const NodeId node : history.pathTo(history.current()))
        design = design.with(history.node(node).edit);
    return hashOf(design);
}

TEST(RandomSteps, InMemoryTheHashIsThatOfTheReplay)
{
    const Design start = smallDesign();
    DesignHash hash;
    int done = 0;
    const int wanted = rounds("BOLSTER_MEMORY_STEPS", 400'000);
    for (unsigned seed = 0; done < wanted; ++seed) {
        Document document;
        document.reset(start);
        Hands hands(seed);
        for (int i = 0; i < 60; ++i, ++done) {
            hands.step(document);
            ASSERT_EQ(hash.follow(document.committed()), replayed(start, document.history())) << seed << " " << i;
        }
    }
}

class RandomStepsOnDisk : public ::testing::Test {
protected:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    QTemporaryDir m_folder{quickFolder()};
};

TEST_F(RandomStepsOnDisk, TheHashIsThatOfTheReplayAfterReopeningToo)
{
    const Design start = smallDesign();
    int done = 0;
    const int wanted = rounds("BOLSTER_DISK_STEPS", 5'000);
    for (unsigned seed = 0; done < wanted; ++seed) {
        const QString file = path(QString::number(seed));
        Document kept; // never closed
        kept.reset(start);
        Document document;
        Journal::Opened opened = Journal::create(file, start);
        ASSERT_TRUE(opened.journal);
        document.reset(opened.project.design, opened.project.history);
        Hands hands(seed);
        Hands sameHands(seed);
        Hands when(seed + 1);
        for (int i = 0; i < 200; ++i, ++done) {
            hands.step(document);
            sameHands.step(kept);
            expectFine(opened.journal->record(document.history(), document.committed()));
            if (when.pick(20) == 0) {
                opened = {};
                opened = Journal::open(file);
                ASSERT_TRUE(opened.journal) << opened.project.problem.english();
                document.reset(opened.project.design, opened.project.history);
            }
            ASSERT_EQ(hashOf(document.committed()), replayed(start, kept.history())) << seed << " " << i;
            ASSERT_EQ(historyText(document.history(), false), historyText(kept.history(), false));
        }
        expectFine(opened.journal->save(path("saved")));
        EXPECT_EQ(openProject(path("saved"), ProjectCheck::Everything).problem.english(), "");
    }
}

TEST_F(RandomStepsOnDisk, AStepThatCouldNotBeStoredComesWithTheNextOne)
{
    Document document;
    document.reset(smallDesign());
    Journal::Opened opened = Journal::create(path("journal"), document.committed());
    Hands hands(3);
    for (int i = 0; i < 300; ++i) {
        hands.step(document);
        if (hands.pick(5) == 0)
            expectFine(opened.journal->record(document.history(), document.committed()));
    }
    expectFine(opened.journal->record(document.history(), document.committed()));
    opened = {};
    const Journal::Opened again = Journal::open(path("journal"));
    EXPECT_EQ(writeDesign(again.project.design), writeDesign(document.committed()));
    EXPECT_EQ(again.project.history.count(), document.history().count());
    for (NodeId id = 0; id < document.history().count(); ++id)
        EXPECT_EQ(again.project.history.node(id).parent, document.history().node(id).parent);
}

} // namespace
} // namespace bolster::test
