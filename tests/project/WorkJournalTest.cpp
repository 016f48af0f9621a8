// Work that was left behind, and those who look for it at the same time.
#include "TestProject.h"

#include "WorkJournal.h"

#include <QTemporaryDir>

#include <atomic>
#include <thread>

namespace bolster {
namespace {

using namespace test;

class WorkJournalTest : public testing::Test {
protected:
    WorkJournalTest() { qputenv("XDG_DATA_HOME", m_home.path().toLocal8Bit()); }
    ~WorkJournalTest() override
    {
        if (m_before.isNull())
            qunsetenv("XDG_DATA_HOME");
        else
            qputenv("XDG_DATA_HOME", m_before);
    }

    /// As of a program that was killed after an edit.
    static void leaveWork(const QString& title)
    {
        Document document;
        document.reset(smallDesign());
        WorkJournal journal(document);
        journal.start({{}, {}, {}, title});
        document.commit(edits::renameElement(document.design(), ElementId{2}, "Back"));
        EXPECT_FALSE(journal.failing());
    }

private:
    const QByteArray m_before = qgetenv("XDG_DATA_HOME");
    const QTemporaryDir m_home;
};

TEST_F(WorkJournalTest, WhatWasLeftIsFoundAndTaken)
{
    leaveWork("Chair");
    const auto left = WorkJournal::left();
    ASSERT_EQ(left.size(), 1);
    EXPECT_EQ(left[0].place.title, "Chair");
    const WorkJournal::Taken taken = WorkJournal::takeLeft(left[0]);
    ASSERT_TRUE(taken.journal);
    EXPECT_EQ(taken.project.history.count(), 2);
    EXPECT_TRUE(WorkJournal::left().empty()) << "it is worked on";
    EXPECT_FALSE(WorkJournal::takeLeft(left[0]).journal);
}

TEST_F(WorkJournalTest, IsTakenWhileOthersLook)
{
    for (const char* title : {"Chair", "Stool", "Bench"})
        leaveWork(title);
    const auto left = WorkJournal::left();
    ASSERT_EQ(left.size(), 3);
    std::atomic<int> looks = 0;
    const std::jthread others([&](const std::stop_token& stop) {
        for (; !stop.stop_requested(); ++looks)
            (void)WorkJournal::left();
    });
    for (int i = 0; i < 200 || looks < 20; ++i) {
        const WorkJournal::Taken taken = WorkJournal::takeLeft(left[static_cast<qsizetype>(i % 3)]);
        ASSERT_TRUE(taken.journal) << taken.project.problem.english();
    }
}

} // namespace
} // namespace bolster
