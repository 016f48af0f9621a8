// What a project with very many edits costs: printed, nothing fails for being slow.
#include "TestProject.h"

#include <QElapsedTimer>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

namespace bolster::test {
namespace {

using LargeProject = TestFiles;

double msSince(const QElapsedTimer& timer)
{
    return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

/// What this disk needs at least, with the same work beside it: as many bytes as a commit writes (two pages), and
/// one sync.
class Floor {
public:
    explicit Floor(const QString& path)
        : m_file(::open(path.toLocal8Bit().constData(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600))
    {}
    ~Floor() { ::close(m_file); }
    Floor(const Floor&) = delete;
    Floor& operator=(const Floor&) = delete;

    double msOfAWrite()
    {
        QElapsedTimer timer;
        timer.start();
        EXPECT_EQ(::pwrite(m_file, m_bytes.data(), m_bytes.size(), m_end), static_cast<ssize_t>(m_bytes.size()));
        EXPECT_EQ(::fdatasync(m_file), 0);
        m_end += static_cast<off_t>(m_bytes.size());
        return msSince(timer);
    }

private:
    int m_file;
    std::vector<char> m_bytes = std::vector<char>(2 * 8192, 1);
    off_t m_end = 0;
};

struct Times {
    std::vector<double> ms;

    double share(std::size_t percent)
    {
        std::sort(ms.begin(), ms.end());
        return ms[std::min(ms.size() * percent / 100, ms.size() - 1)];
    }
    double mean() const { return std::accumulate(ms.begin(), ms.end(), 0.0) / static_cast<double>(ms.size()); }
};

TEST_F(LargeProject, IsHardlyLargerThanItsEdits)
{
    const int edits = rounds("BOLSTER_LARGE_EDITS", 20'000);
    Document document;
    document.reset(smallDesign());
    Journal::Opened opened = Journal::create(path("journal"), document.committed());
    Hands hands(1);
    while (document.history().count() <= edits) {
        document.commit(hands.edit(document.design()));
        if (document.history().count() % 1000 == 0) // one by one is measured below
            expectFine(opened.journal->record(document.history(), document.committed()));
    }
    expectFine(opened.journal->record(document.history(), document.committed()));

    const auto msOfAnEdit = [&] {
        document.commit(hands.edit(document.design()));
        QElapsedTimer timer;
        timer.start();
        expectFine(opened.journal->record(document.history(), document.committed()));
        return msSince(timer);
    };
    Times commits, floor;
    Floor disk(path("floor"));
    while (commits.ms.size() < 2000) { // by turns: whatever else goes on meets both
        commits.ms.push_back(msOfAnEdit());
        floor.ms.push_back(disk.msOfAWrite());
    }
    std::atomic<bool> saving = true;
    double saved = 0; // s
    std::thread saver([&] {
        QElapsedTimer timer;
        timer.start();
        expectFine(opened.journal->save(path("a.bolster")));
        saved = static_cast<double>(timer.nsecsElapsed()) / 1e9;
        saving = false;
    });
    std::vector<double> meanwhile;
    while (saving)
        meanwhile.push_back(msOfAnEdit());
    saver.join();

    QElapsedTimer timer;
    timer.start();
    const std::clock_t begin = std::clock(); // says more on a busy machine
    const OpenedProject project = openProject(path("a.bolster"));
    const double processor = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const double opening = static_cast<double>(timer.nsecsElapsed()) / 1e9;
    ASSERT_EQ(project.problem.english(), "");
    EXPECT_GE(project.history.count(), edits);
    double payload = 0;
    for (NodeId id = 0; id < project.history.count(); ++id)
        payload += static_cast<double>(encodeChanges(storedChanges(project, id).value()).size());
    const double times = static_cast<double>(QFileInfo(path("a.bolster")).size()) / payload;
    EXPECT_LT(times, 2);
    std::printf("%d edits: reopened in %.2f s (%.2f s of processor time), file %.1f MB, %.2f times its edits\n",
                project.history.count() - 1, opening, processor,
                static_cast<double>(QFileInfo(path("a.bolster")).size()) / 1e6, times);
    const auto print = [](const char* what, double commit, double least) {
        std::printf("a commit: %-6s %6.2f ms, %4.1f times the %6.2f ms of writing and syncing as many bytes\n",
                    what, commit, commit / least, least);
    };
    print("median", commits.share(50), floor.share(50));
    print("mean", commits.mean(), floor.mean());
    print("p99", commits.share(99), floor.share(99));
    print("max", commits.share(100), floor.share(100));
    std::printf("%zu edits while saving for %.2f s: the longest took %.1f ms\n", meanwhile.size(), saved,
                *std::max_element(meanwhile.begin(), meanwhile.end()));
}

} // namespace
} // namespace bolster::test
