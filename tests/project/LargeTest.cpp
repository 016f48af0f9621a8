// What a project with very many edits costs: printed, nothing fails for being slow.
#include "TestProject.h"

#include <QElapsedTimer>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <thread>

namespace bolster::test {
namespace {

using LargeProject = TestFiles;

TEST_F(LargeProject, OpensQuicklyAndIsHardlyLargerThanItsEdits)
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
        return static_cast<double>(timer.nsecsElapsed()) / 1e6;
    };
    std::vector<double> commits;
    while (commits.size() < 500)
        commits.push_back(msOfAnEdit());
    std::sort(commits.begin(), commits.end());
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
    std::printf("%d edits: reopened in %.2f s (%.2f s of processor time), file %.1f MB, %.2f times its edits; a "
                "commit takes %.2f ms, "
                "p99 %.2f ms\n",
                project.history.count() - 1, opening, processor,
                static_cast<double>(QFileInfo(path("a.bolster")).size()) / 1e6,
                static_cast<double>(QFileInfo(path("a.bolster")).size()) / payload, commits[commits.size() / 2],
                commits[commits.size() * 99 / 100]);
    std::printf("%zu edits while saving for %.2f s: the longest took %.1f ms\n", meanwhile.size(), saved,
                *std::max_element(meanwhile.begin(), meanwhile.end()));
}

} // namespace
} // namespace bolster::test
