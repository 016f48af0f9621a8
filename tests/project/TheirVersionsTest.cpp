// Somebody else has saved the same project: their versions become a branch of ours.
#include "TestProject.h"

namespace bolster::test {
namespace {

class TheirVersions : public TestFiles {
protected:
    struct Desk {
        std::unique_ptr<Journal> journal;
        Document document;

        void take(Journal::Opened opened)
        {
            ASSERT_EQ(opened.project.problem.english(), "");
            document.reset(opened.project.design, opened.project.history);
            journal = std::move(opened.journal);
        }
        void record() { expectFine(journal->record(document.history(), document.committed())); }
        void work(unsigned seed, int edits)
        {
            Hands hands(seed);
            for (int i = 0; i < edits; ++i) {
                document.commit(edits::renameElement(document.design(), ElementId{2},
                                                     std::to_string(seed) + " " + std::to_string(i)));
                document.commit(hands.edit(document.design()));
                record();
            }
        }
        void save(const QString& path) { expectFine(journal->save(path)); }
        NodeId takeIn(const QString& path, const std::string& name = "From the file")
        {
            Journal::TakenIn taken;
            const OpenedProject theirs = openProject(path);
            EXPECT_EQ(theirs.problem.english(), "");
            expectFine(journal->takeIn(theirs, name, document.history(), taken));
            document.takeIn(taken.nodes, taken.edits);
            for (const auto& [node, text] : taken.names)
                document.nameVersion(node, text);
            for (const auto& [node, text] : taken.branches)
                document.nameBranch(node, text);
            record();
            return taken.tip;
        }
    };

    TheirVersions()
    {
        ours.take(Journal::create(path("ours"), smallDesign()));
        ours.work(1, 10);
        ours.save(file);
        theirs.take(Journal::begin(file, path("theirs")));
    }

    Journal::Theirs compare() { return ours.journal->compare(openProject(file)); }

    const QString file = path("a.bolster");
    Desk ours, theirs;
};

TEST_F(TheirVersions, BecomeABranchAndSavingWorksAgain)
{
    theirs.work(2, 20);
    theirs.document.nameVersion(theirs.document.history().current() - 2, "Softer");
    expectFine(theirs.journal->setNames(theirs.document.history().current() - 2, "Softer"));
    theirs.save(file);
    ours.work(3, 5);
    const Design mine = ours.document.committed();
    const NodeId here = ours.document.history().current();
    const NodeId count = ours.document.history().count();
    EXPECT_EQ(compare(), Journal::Theirs::MoreVersions);

    const NodeId tip = ours.takeIn(file);
    EXPECT_EQ(ours.document.history().current(), here);
    EXPECT_TRUE(ours.document.committed() == mine);
    EXPECT_EQ(ours.document.history().node(tip).name, "From the file");
    EXPECT_EQ(ours.document.history().node(tip - 2).name, "Softer");
    EXPECT_GT(ours.document.history().count(), count + 20);
    EXPECT_EQ(compare(), Journal::Theirs::NothingNew);
    EXPECT_EQ(ours.journal->base(), openProject(file).seal);
    ours.document.jumpTo(tip);
    EXPECT_EQ(writeDesign(ours.document.committed()), writeDesign(theirs.document.committed()));
    ours.work(4, 2); // on their branch
    ours.document.jumpTo(here);
    EXPECT_TRUE(ours.document.committed() == mine);
    ours.record();

    ours.save(file);
    const OpenedProject both = openProject(file, ProjectCheck::Everything);
    ASSERT_EQ(both.problem.english(), "");
    EXPECT_EQ(historyText(both.history).substr(40), historyText(ours.document.history()).substr(40));
    EXPECT_EQ(both.history.node(tip).name, "From the file");

    // The other one takes ours in, and both have the same.
    theirs.work(5, 1);
    theirs.takeIn(file, "");
    EXPECT_EQ(theirs.journal->compare(both), Journal::Theirs::NothingNew);
    theirs.journal.reset();
    const Journal::Opened again = Journal::open(path("theirs"));
    EXPECT_EQ(historyText(again.project.history).substr(40), historyText(theirs.document.history()).substr(40));
}

TEST_F(TheirVersions, RedoStillGoesWhereItWent)
{
    theirs.work(2, 3);
    theirs.save(file);
    ours.work(3, 3);
    const NodeId end = ours.document.history().current();
    while (ours.document.history().current() > 5)
        ours.document.undo();
    ours.record();
    ours.takeIn(file);
    ours.journal.reset();
    ours.take(Journal::open(path("ours")));
    while (ours.document.history().canRedo())
        ours.document.redo();
    EXPECT_EQ(ours.document.history().current(), end);
}

TEST_F(TheirVersions, NamesAloneAreTakenInToo)
{
    expectFine(theirs.journal->setNames(3, "Theirs"));
    expectFine(theirs.journal->setNames(4, "Theirs"));
    theirs.save(file);
    ours.document.nameVersion(4, "Ours");
    expectFine(ours.journal->setNames(4, "Ours"));
    EXPECT_EQ(compare(), Journal::Theirs::MoreVersions);
    const NodeId count = ours.document.history().count();
    ours.takeIn(file);
    EXPECT_EQ(ours.document.history().count(), count);
    EXPECT_EQ(ours.document.history().node(3).name, "Theirs");
    EXPECT_EQ(ours.document.history().node(4).name, "Ours");
    EXPECT_EQ(compare(), Journal::Theirs::NothingNew);
}

TEST_F(TheirVersions, NamesOfBranchesAreTakenInToo)
{
    theirs.work(2, 2);
    const NodeId last = theirs.document.history().current();
    for (const NodeId node : {3, 4, 5, last})
        expectFine(theirs.journal->setNames(node, node == 5 ? "Their version" : "", "Their branch"));
    theirs.save(file);
    ours.document.nameBranch(4, "Our branch");
    expectFine(ours.journal->setNames(4, "", "Our branch"));
    ours.document.nameVersion(5, "Our version");
    expectFine(ours.journal->setNames(5, "Our version"));
    EXPECT_EQ(compare(), Journal::Theirs::MoreVersions);
    const NodeId tip = ours.takeIn(file);
    const auto expectNames = [&](const History& history) {
        EXPECT_EQ(history.node(3).branch, "Their branch");
        EXPECT_EQ(history.node(4).branch, "Our branch");
        EXPECT_EQ(history.node(5).branch, "Their branch");
        EXPECT_EQ(history.node(5).name, "Our version");
        EXPECT_EQ(history.node(tip).branch, "Their branch");
        EXPECT_EQ(history.node(tip).name, "From the file");
    };
    expectNames(ours.document.history());
    EXPECT_EQ(compare(), Journal::Theirs::NothingNew);
    ours.save(file);
    expectNames(openProject(file, ProjectCheck::Everything).history);
}

TEST_F(TheirVersions, TheirFilesComeAlong)
{
    write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    std::string name = "chair.obj";
    expectFine(theirs.journal->addAsset(name, path("chair.obj")));
    theirs.work(2, 1);
    theirs.save(file);
    ours.takeIn(file);
    ours.save(file);
    const OpenedProject both = openProject(file, ProjectCheck::Everything);
    EXPECT_TRUE(both.assets.contains("chair.obj"));

    // The same name for something else.
    std::string stool = "stool.obj";
    expectFine(theirs.journal->addAsset(stool, path("chair.obj")));
    theirs.work(7, 1);
    theirs.save(path("b.bolster"));
    expectFine(ours.journal->addAsset(stool, path("other.obj")));
    ours.work(6, 1);
    Journal::TakenIn taken;
    const Message why = ours.journal->takeIn(openProject(path("b.bolster")), "", ours.document.history(), taken);
    EXPECT_NE(why.english().find("stool.obj"), std::string::npos) << why.english();
    ours.save(file);
    EXPECT_EQ(openProject(file, ProjectCheck::Everything).problem.english(), "");
}

TEST_F(TheirVersions, AnotherProjectIsNotTakenIn)
{
    Desk others;
    others.take(Journal::create(path("others"), smallDesign()));
    others.save(file);
    EXPECT_EQ(compare(), Journal::Theirs::AnotherProject);
    Journal::TakenIn taken;
    EXPECT_FALSE(ours.journal->takeIn(openProject(file), "", ours.document.history(), taken).empty());
    ours.work(1, 2);
    ours.save(path("b.bolster"));
    EXPECT_EQ(openProject(path("b.bolster"), ProjectCheck::Everything).problem.english(), "");
}

/// The program died after the file was in its place, before it knew.
TEST_F(TheirVersions, WhatWeHaveAllOfIsOurOwn)
{
    ours.work(1, 3);
    expectFine(ours.journal->saveCopy(file, {}));
    EXPECT_NE(openProject(file).seal, ours.journal->base());
    EXPECT_EQ(compare(), Journal::Theirs::NothingNew);
}

} // namespace
} // namespace bolster::test
