// Power cuts, and disks that fail: what was acknowledged is there afterwards.
#include "DesignHash.h"
#include "FaultCalls.h"
#include "FaultDisk.h"
#include "TestProject.h"

#include <QDir>

#include <cerrno>
#include <optional>
#include <thread>

namespace bolster::test {
namespace {

const char* const name = "fault-disk";
const QString file = "/journal";

/// A designer at work on a disk that fails at some time.
class Work {
public:
    Work(unsigned seed, Journal::Opened opened)
        : m_hands(seed)
        , m_journal(std::move(opened.journal))
    {
        m_document.reset(opened.project.design, opened.project.history);
        m_states = {state()};
    }

    /// True when the step was acknowledged.
    bool step()
    {
        m_hands.step(m_document);
        m_states.push_back(state());
        if (!m_journal->record(m_document.history(), m_document.committed()).empty())
            return false;
        m_states = {state()};
        return true;
    }

    /// Stores what could not be stored before.
    void catchUp()
    {
        expectFine(m_journal->record(m_document.history(), m_document.committed()));
        m_states = {state()};
    }

    void end() { m_journal.reset(); }
    Journal& journal() { return *m_journal; }

    /// Whether a project holds all that was acknowledged, and nothing but what was done.
    void check(const OpenedProject& project) const
    {
        ASSERT_EQ(project.problem.english(), "");
        const std::string found = hexText(hashOf(project.design)) + historyText(project.history, false);
        EXPECT_TRUE(std::find(m_states.begin(), m_states.end(), found) != m_states.end());
    }

private:
    std::string state() const
    {
        return hexText(hashOf(m_document.committed())) + historyText(m_document.history(), false);
    }
    Document m_document;
    Hands m_hands;
    std::unique_ptr<Journal> m_journal;
    std::vector<std::string> m_states; // the acknowledged one, and what came after it
};

TEST(Faults, APowerCutLosesNothingThatWasAcknowledged)
{
    const int wanted = rounds("BOLSTER_POWER_CUTS", 500);
    std::mt19937 random(1);
    for (int done = 0; done < wanted;) {
        FaultDisk disk(name);
        Journal::Opened opened = Journal::create(file, smallDesign(), name);
        for (int cut = 0; cut < 5 && done < wanted; ++cut, ++done) {
            ASSERT_TRUE(opened.journal);
            Work work(static_cast<unsigned>(done), std::move(opened));
            disk.failAt(static_cast<int>(random() % (random() % 5 == 0 ? 3'000 : 100)), SQLITE_IOERR, true);
            for (int steps = 0; steps < 60 && work.step(); ++steps) {
            }
            work.end();
            disk.heal();
            disk.powerCut(random);
            opened = Journal::open(file, name);
            work.check(opened.project);
            if (::testing::Test::HasFailure())
                FAIL() << "power cut number " << done;
        }
    }
}

/// The disk is that of the journal; the project lies on another one.
TEST(Faults, APowerCutWhileSavingAmongEditsLosesNothingThatWasAcknowledged)
{
    const int wanted = rounds("BOLSTER_POWER_CUTS", 500) / 10;
    const QTemporaryDir folder(quickFolder());
    const QString project = folder.filePath("a.bolster");
    std::mt19937 random(3);
    std::optional<FaultDisk> disk;
    Journal::Opened opened;
    int saved = 0;
    for (int cut = 0; cut < wanted; ++cut) {
        if (cut % 50 == 0) { // saving and checking take time with the length of the history
            opened = {};
            disk.reset();
            disk.emplace(name);
            opened = Journal::create(file, smallDesign(), name);
            expectFine(opened.journal->save(project));
        }
        ASSERT_TRUE(opened.journal);
        Work work(static_cast<unsigned>(cut), std::move(opened));
        disk->failAt(static_cast<int>(random() % 1'000), SQLITE_IOERR, true);
        std::thread saver([&] {
            while (work.journal().save(project).empty())
                ++saved;
        });
        while (work.step()) {
        }
        saver.join();
        work.end();
        disk->heal();
        disk->powerCut(random);
        opened = Journal::open(file, name);
        work.check(opened.project);
        EXPECT_EQ(openProject(project, ProjectCheck::Everything).problem.english(), "");
        if (::testing::Test::HasFailure())
            FAIL() << "power cut number " << cut;
    }
    EXPECT_GT(saved, wanted / 2);
}

TEST(Faults, APowerCutWhileAJournalIsMadeLeavesAJournalOrNone)
{
    std::mt19937 random(2);
    bool made = false;
    for (int call = 0; !made; ++call) {
        FaultDisk disk(name);
        disk.failAt(call, SQLITE_IOERR, true);
        made = Journal::create(file, smallDesign(), name).journal != nullptr;
        disk.heal();
        disk.powerCut(random);
        const Journal::Opened opened = Journal::open(file, name);
        EXPECT_TRUE(!made || opened.journal) << call;
        if (opened.journal) {
            EXPECT_EQ(writeDesign(opened.project.design), writeDesign(smallDesign()));
        }
    }
}

/// Each single call of a scenario fails once, or from there on, until the program is started again.
void failEverywhere(int code, bool lasting)
{
    for (int call = 0;; ++call) {
        FaultDisk disk(name);
        Work work(7, Journal::create(file, smallDesign(), name));
        disk.failAt(call, code, lasting);
        for (int step = 0; step < 40; ++step)
            work.step();
        const bool failed = disk.failed();
        if (!lasting) {
            disk.heal();
            work.catchUp();
        }
        work.end();
        disk.heal();
        work.check(Journal::open(file, name).project);
        if (::testing::Test::HasFailure())
            FAIL() << "call " << call << ", code " << code;
        if (!failed)
            break;
    }
}

TEST(Faults, AReadOrWriteErrorAtAnyCallLosesNothing)
{
    failEverywhere(SQLITE_IOERR, false);
    failEverywhere(SQLITE_IOERR, true);
}

TEST(Faults, ADiskThatIsFullAtAnyCallLosesNothing)
{
    failEverywhere(SQLITE_FULL, false);
    failEverywhere(SQLITE_FULL, true);
}

/// The file of a project is the old one or the new one whichever call fails, and the next save works.
void failWhileSaving(int error, bool lasting)
{
    const QTemporaryDir folder(quickFolder());
    const QString project = folder.filePath("a.bolster");
    const QString journal = folder.filePath("journal");
    Work work(9, Journal::create(journal, smallDesign()));
    work.step();
    expectFine(work.journal().save(project));
    int refused = 0;
    for (int call = 0;; ++call) {
        const OpenedProject before = openProject(project);
        ASSERT_TRUE(work.step());
        bool failed = false;
        {
            const FaultCalls calls(call, error, lasting);
            const Message problem = work.journal().save(project);
            failed = calls.failed();
            refused += !problem.empty();
            EXPECT_TRUE(failed || problem.empty()) << problem.english();
        }
        const OpenedProject after = openProject(project, ProjectCheck::Everything);
        ASSERT_EQ(after.problem.english(), "") << call;
        if (after.seal != before.seal)
            work.check(after);
        EXPECT_EQ(work.journal().compare(after), Journal::Theirs::NothingNew) << "it is our own";
        EXPECT_EQ(QDir(folder.path()).entryList({".bolster*"}, QDir::Files | QDir::Hidden).join(' ').toStdString(),
                  "")
            << call;
        work.catchUp();
        expectFine(work.journal().save(project));
        work.check(openProject(project));
        if (::testing::Test::HasFailure())
            FAIL() << "call " << call;
        if (!failed)
            break;
    }
    EXPECT_GT(refused, 2);
    work.end();
    work.check(Journal::open(journal).project);
}

TEST(Faults, ASyncOrRenameThatFailsLeavesTheOldOrTheNewFile)
{
    for (const int error : {EIO, ENOSPC, EACCES}) {
        failWhileSaving(error, false);
        failWhileSaving(error, true);
    }
}

TEST(Faults, OpeningReportsAnErrorAtAnyCallAndWorksTheNextTime)
{
    FaultDisk disk(name);
    Work work(8, Journal::create(file, smallDesign(), name));
    for (int step = 0; step < 40; ++step)
        work.step();
    work.end();
    for (int call = 0;; ++call) {
        disk.failAt(call, SQLITE_IOERR, false);
        const Journal::Opened opened = Journal::open(file, name);
        const bool failed = disk.failed();
        EXPECT_EQ(opened.journal == nullptr, !opened.project.problem.empty()) << call;
        if (opened.journal)
            work.check(opened.project);
        if (!failed)
            break;
    }
    disk.heal();
    work.check(Journal::open(file, name).project);
}

} // namespace
} // namespace bolster::test
