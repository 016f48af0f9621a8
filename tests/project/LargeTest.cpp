// What a project with very many edits costs: printed, nothing fails for being slow.
#include "TestProject.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>

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

    std::vector<double> commits; // ms
    while (commits.size() < 500) {
        document.commit(hands.edit(document.design()));
        QElapsedTimer timer;
        timer.start();
        expectFine(opened.journal->record(document.history(), document.committed()));
        commits.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    std::sort(commits.begin(), commits.end());
    expectFine(opened.journal->save(path("a.bolster")));

    QElapsedTimer timer;
    timer.start();
    const OpenedProject project = openProject(path("a.bolster"));
    const double opening = static_cast<double>(timer.nsecsElapsed()) / 1e9;
    ASSERT_EQ(project.problem.english(), "");
    EXPECT_EQ(project.history.count(), document.history().count());
    double payload = 0;
    for (NodeId id = 0; id < project.history.count(); ++id)
        payload += static_cast<double>(encodeChanges(storedChanges(project, id).value()).size());
    std::printf("%d edits: reopened in %.2f s, file %.1f MB, %.2f times its edits; a commit takes %.2f ms, "
                "p99 %.2f ms\n",
                project.history.count() - 1, opening,
                static_cast<double>(QFileInfo(path("a.bolster")).size()) / 1e6,
                static_cast<double>(QFileInfo(path("a.bolster")).size()) / payload, commits[commits.size() / 2],
                commits[commits.size() * 99 / 100]);
}

} // namespace
} // namespace bolster::test
