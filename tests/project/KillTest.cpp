// The program is killed at any instant, in the midst of edits or of saving.
#include "DesignHash.h"
#include "TestProject.h"

#include <QDir>

#include <chrono>
#include <csignal>
#include <functional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace bolster::test {
namespace {

/// Another process, which says how far it got.
class Child {
public:
    /// `work` runs there: it calls its argument each time something is done. It never returns.
    explicit Child(const std::function<void(const std::function<void()>& acknowledge)>& work)
    {
        int ends[2];
        EXPECT_EQ(::pipe(ends), 0);
        m_process = ::fork();
        if (m_process == 0) {
            ::close(ends[0]);
            work([&] {
                if (::write(ends[1], "x", 1) != 1)
                    ::_exit(1);
            });
            ::_exit(0);
        }
        ::close(ends[1]);
        m_pipe = ends[0];
    }
    ~Child()
    {
        kill();
        ::close(m_pipe);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Until so many things are done.
    void await(int count)
    {
        while (m_done < count && readMore()) {
        }
    }
    void kill()
    {
        if (m_process <= 0)
            return;
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
        m_process = 0;
        while (readMore()) { // acknowledged before it died
        }
    }
    int done() const { return m_done; }

private:
    bool readMore()
    {
        char bytes[256];
        const ssize_t got = ::read(m_pipe, bytes, sizeof bytes);
        m_done += got > 0 ? static_cast<int>(got) : 0;
        return got > 0;
    }

    pid_t m_process = 0;
    int m_pipe = -1;
    int m_done = 0;
};

void spin(int microseconds)
{
    const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(microseconds);
    while (std::chrono::steady_clock::now() < until) {
    }
}

std::string stateOf(const Design& design, const History& history)
{
    return hexText(hashOf(design)) + historyText(history, false);
}

class KillTest : public TestFiles {
protected:
    KillTest() { startAgain(); }

    /// With an empty history. Long runs do it now and then: checking a history takes time with its length.
    void startAgain()
    {
        for (const char* name : {"journal", "journal-wal", "journal-shm", "a.bolster"})
            QFile::remove(path(name));
        m_known.reset(smallDesign());
        EXPECT_TRUE(Journal::create(path("journal"), smallDesign()).journal);
    }

    /// What the child does: the same steps as `m_hands` here, without end.
    void work(const std::function<void()>& acknowledge, const std::function<void(Journal&)>& afterEach)
    {
        const Journal::Opened opened = Journal::open(path("journal"));
        if (!opened.journal)
            ::_exit(1);
        Document document;
        document.reset(opened.project.design, opened.project.history);
        document.spendIds(largestIdEver(opened.project));
        for (;;) {
            m_hands.step(document);
            if (!opened.journal->record(document.history(), document.committed()).empty())
                ::_exit(1);
            afterEach(*opened.journal);
            acknowledge();
        }
    }

    /// Takes the known steps until the state is this one; false when it is not within the next `most` steps.
    bool follow(const std::string& state, int least, int most)
    {
        for (int step = 0; step <= most; ++step) {
            if (step >= least && stateOf(m_known.committed(), m_known.history()) == state)
                return true;
            m_hands.step(m_known);
        }
        return false;
    }

    Document m_known;
    Hands m_hands{1};
    std::mt19937 m_random{1};
};

TEST_F(KillTest, NoAcknowledgedEditIsLost)
{
    const int wanted = rounds("BOLSTER_KILLS", 50);
    int edits = 0;
    for (int round = 0; round < wanted; ++round) {
        if (round > 0 && round % 200 == 0)
            startAgain();
        Child child([&](const auto& acknowledge) { work(acknowledge, [](Journal&) {}); });
        child.await(static_cast<int>(m_random() % 20));
        spin(static_cast<int>(m_random() % 3000));
        child.kill();
        const Journal::Opened opened = Journal::open(path("journal"));
        ASSERT_EQ(opened.project.problem.english(), "") << round;
        const std::string state = stateOf(opened.project.design, opened.project.history);
        ASSERT_TRUE(follow(state, child.done(), child.done() + 1)) << round;
        edits += child.done();
    }
    EXPECT_GT(edits, wanted);
}

TEST_F(KillTest, WhenSavingIsKilledTheFileIsTheOldOrTheNewOne)
{
    const int wanted = rounds("BOLSTER_SAVE_KILLS", 80);
    std::string lastSaved;
    for (int round = 0; round < wanted; ++round) {
        if (round % 200 == 0) {
            startAgain();
            expectFine(Journal::open(path("journal")).journal->save(path("a.bolster")));
        }
        Child child([&](const auto& acknowledge) {
            work(acknowledge, [&](Journal& journal) {
                if (!journal.save(path("a.bolster")).empty())
                    ::_exit(1);
            });
        });
        child.await(static_cast<int>(m_random() % 3));
        spin(static_cast<int>(m_random() % 20'000));
        child.kill();
        const OpenedProject saved = openProject(path("a.bolster"));
        ASSERT_EQ(saved.problem.english(), "") << round;
        const Journal::Opened journal = Journal::open(path("journal"));
        ASSERT_EQ(journal.project.problem.english(), "") << round;
        const std::string found = stateOf(saved.design, saved.history);
        const bool stillTheOld = child.done() == 0 && found == lastSaved;
        ASSERT_TRUE(stillTheOld || follow(found, child.done(), child.done() + 1)) << round;
        lastSaved = found;
        const std::string latest = stateOf(journal.project.design, journal.project.history);
        ASSERT_TRUE(follow(latest, 0, 1)) << round;
    }
}

TEST_F(KillTest, EditsThatCameWhileSavingAreThere)
{
    const int wanted = rounds("BOLSTER_KILLS", 50);
    for (int round = 0; round < wanted; ++round) {
        Child child([&](const auto& acknowledge) {
            std::thread saver;
            work(acknowledge, [&](Journal& journal) {
                if (!saver.joinable())
                    saver = std::thread([&] {
                        while (journal.save(path("a.bolster")).empty()) {
                        }
                        ::_exit(1);
                    });
            });
        });
        child.await(1 + static_cast<int>(m_random() % 30));
        spin(static_cast<int>(m_random() % 3'000));
        child.kill();
        const Journal::Opened journal = Journal::open(path("journal"));
        ASSERT_EQ(journal.project.problem.english(), "") << round;
        ASSERT_TRUE(
            follow(stateOf(journal.project.design, journal.project.history), child.done(), child.done() + 1))
            << round;
        if (QFileInfo::exists(path("a.bolster"))) {
            const OpenedProject saved = openProject(path("a.bolster"));
            ASSERT_EQ(saved.problem.english(), "") << round;
            ASSERT_LE(saved.history.count(), m_known.history().count());
        }
    }
    EXPECT_TRUE(QFileInfo::exists(path("a.bolster")));
}

TEST_F(KillTest, AFullDiskWhileSavingLeavesTheOldOrTheNewFile)
{
    expectFine(Journal::open(path("journal")).journal->save(path("a.bolster")));
    int refused = 0;
    for (rlim_t most = 0; most < 150'000; most += 2'048) {
        Child child([&](const auto& acknowledge) {
            ::signal(SIGXFSZ, SIG_IGN); // a write beyond the limit fails then, as on a full disk
            const Journal::Opened opened = Journal::open(path("journal"));
            const rlimit limit = {most, most};
            ::setrlimit(RLIMIT_FSIZE, &limit);
            if (opened.journal && opened.journal->save(path("a.bolster")).empty())
                acknowledge();
        });
        child.await(1);
        child.kill();
        refused += child.done() == 0;
        const OpenedProject saved = openProject(path("a.bolster"), ProjectCheck::Everything);
        ASSERT_EQ(saved.problem.english(), "") << most;
        ASSERT_EQ(writeDesign(saved.design), writeDesign(smallDesign()));
        ASSERT_TRUE(Journal::open(path("journal")).journal) << most;
        EXPECT_EQ(QDir(m_folder.path()).entryList({".bolster*"}, QDir::Files | QDir::Hidden).size(), 0) << most;
    }
    EXPECT_GT(refused, 10);
}

TEST_F(KillTest, CopiesTakenDuringWorkAreWhole)
{
    const int wanted = rounds("BOLSTER_COPIES", 500);
    expectFine(Journal::open(path("journal")).journal->save(path("a.bolster")));
    Child child([&](const auto& acknowledge) {
        work(acknowledge, [&](Journal& journal) {
            if (!journal.save(path("a.bolster")).empty())
                ::_exit(1);
        });
    });
    std::set<std::string> different;
    for (int copy = 0; copy < wanted; ++copy) {
        const QString name = path("copy" + QString::number(copy));
        ASSERT_TRUE(QFile::copy(path("a.bolster"), name));
        const OpenedProject project = openProject(name);
        ASSERT_EQ(project.problem.english(), "") << copy;
        different.insert(hexText(project.seal));
        QFile::remove(name);
    }
    EXPECT_GT(different.size(), 1u);
}

} // namespace
} // namespace bolster::test
