// Whatever the user does, and whenever the program is closed and opened again: the design is what its replay says.
#include "DesignHash.h"
#include "TestProject.h"

#include <vector>

namespace bolster::test {
namespace {

/// The design of each node from nothing, by the edits of a history that was never stored, always forward.
class Replay {
public:
    explicit Replay(const Design& start)
        : m_designs{start}
        , m_hashes{hashOf(start)}
    {}

    Hash now(const History& history)
    {
        for (auto node = static_cast<NodeId>(m_designs.size()); node < history.count(); ++node) {
            const auto parent = static_cast<std::size_t>(history.node(node).parent);
            m_designs.push_back(m_designs[parent].with(history.node(node).edit));
            m_hashes.push_back(hashOf(m_designs.back()));
        }
        return m_hashes[static_cast<std::size_t>(history.current())];
    }

private:
    std::vector<Design> m_designs;
    std::vector<Hash> m_hashes;
};

constexpr int parts = 4; // that can run at the same time

class RandomSteps : public ::testing::TestWithParam<int> {
protected:
    unsigned firstSeed() const { return static_cast<unsigned>(GetParam()) * 1'000'000U; }
};
INSTANTIATE_TEST_SUITE_P(Parts, RandomSteps, ::testing::Range(0, parts));

TEST_P(RandomSteps, InMemoryTheHashIsThatOfTheReplay)
{
    const Design start = smallDesign();
    DesignHash hash;
    int done = 0;
    const int wanted = rounds("BOLSTER_MEMORY_STEPS", 300'000) / parts;
    for (unsigned seed = firstSeed(); done < wanted; ++seed) {
        Document document;
        document.reset(start);
        Replay replay(start);
        Hands hands(seed);
        for (int i = 0; i < 60; ++i, ++done) {
            hands.step(document);
            ASSERT_EQ(hash.follow(document.committed()), replay.now(document.history())) << seed << " " << i;
        }
    }
}

class RandomStepsOnDisk : public RandomSteps {
protected:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    QTemporaryDir m_folder{quickFolder()};
};

INSTANTIATE_TEST_SUITE_P(Parts, RandomStepsOnDisk, ::testing::Range(0, parts));

TEST_P(RandomStepsOnDisk, TheHashIsThatOfTheReplayAfterReopeningToo)
{
    const Design start = smallDesign();
    int done = 0;
    const int wanted = rounds("BOLSTER_DISK_STEPS", 20'000) / parts;
    for (unsigned seed = firstSeed(); done < wanted; ++seed) {
        const QString file = path(QString::number(seed));
        Document kept; // never closed
        kept.reset(start);
        Replay replay(start);
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
                document.spendIds(largestIdEver(opened.project));
            }
            ASSERT_EQ(hashOf(document.committed()), replay.now(kept.history())) << seed << " " << i;
            ASSERT_EQ(historyText(document.history(), false), historyText(kept.history(), false));
        }
        expectFine(opened.journal->save(path("saved")));
        EXPECT_EQ(openProject(path("saved"), ProjectCheck::Everything).problem.english(), "");
    }
}

TEST_P(RandomStepsOnDisk, AStepThatCouldNotBeStoredComesWithTheNextOne)
{
    Document document;
    document.reset(smallDesign());
    Journal::Opened opened = Journal::create(path("journal"), document.committed());
    Hands hands(firstSeed() + 3);
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
