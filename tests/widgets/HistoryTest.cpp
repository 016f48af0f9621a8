// The history: names of versions, what the search leaves.
#include "Document.h"
#include "ElementEdits.h"
#include "HistoryModel.h"
#include "HistoryPanel.h"
#include "HistoryView.h"
#include "Picture.h"
#include "TestDesigns.h"

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QTest>

#include <gtest/gtest.h>

#include <random>

namespace bolster {
namespace {

class HistoryTest : public testing::Test {
protected:
    HistoryTest()
    {
        document.reset(twoSquares());
        panel.resize(300, 300);
        panel.show();
        rename("Seat");
        rename("Back");
        rename("Bolster");
    }

    void rename(const char* name) { document.commit(edits::renameElement(document.design(), firstSquare, name)); }
    QModelIndex row(int at) { return view.model()->index(at, 0); }
    QPoint place(int at) { return view.visualRect(row(at)).center(); }

    Document document;
    HistoryPanel panel{document};
    HistoryView& view = panel.view();
};

TEST_F(HistoryTest, ADoubleClickJumpsAndNamesThatVersion)
{
    const QAbstractItemModelTester tester(view.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, place(1));
    QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, place(1));
    EXPECT_EQ(document.history().current(), 1);
    auto* editor = view.findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    QTest::keyClicks(editor, " With welt ");
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return document.history().node(1).name == "With welt"; }));
    EXPECT_EQ(row(1).data(HistoryModel::NameRole).toString(), "With welt");
    EXPECT_EQ(document.history().current(), 1);
    EXPECT_FALSE(document.gestureRunning());
    keepPicture(panel, "history-named");

    document.nameVersion(1, "");
    EXPECT_EQ(row(1).data(HistoryModel::NameRole).toString(), "");
}

TEST_F(HistoryTest, ASearchLeavesWhatHasTheWords)
{
    document.nameVersion(2, "With welt");
    const auto shown = [&] {
        QList<int> rows;
        for (int at = 0; at < view.model()->rowCount(); ++at)
            if (!view.isRowHidden(at))
                rows << at;
        return rows;
    };
    QTest::keyClicks(&panel.search(), "welt");
    EXPECT_EQ(shown(), QList<int>{2});
    panel.search().setText("to bols");
    EXPECT_EQ(shown(), QList<int>{3});
    rename("Bolster left"); // what comes meanwhile is searched, too
    EXPECT_EQ(shown(), (QList<int>{3, 4}));
    panel.search().clear();
    EXPECT_EQ(shown().size(), 5);
}

TEST_F(HistoryTest, ABranchIsNamedInItsFirstLineFromAnyOfItsVersions)
{
    const QAbstractItemModelTester tester(view.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    EXPECT_FALSE(document.history().branchOf(3)) << "there is one way only";
    view.nameBranchOf(3);
    EXPECT_FALSE(view.findChild<QLineEdit*>());
    document.jumpTo(1);
    rename("Lid");
    rename("Cover");
    rename("Top"); // 4 to 6, beside 2 and 3
    EXPECT_EQ(document.history().branchOf(6), 4);
    EXPECT_EQ(document.history().branchOf(3), 2);
    EXPECT_FALSE(document.history().branchOf(1));

    const auto type = [&](NodeId node, const char* name) {
        view.nameBranchOf(node);
        auto* editor = view.findChild<QLineEdit*>();
        ASSERT_TRUE(editor);
        EXPECT_FALSE(editor->placeholderText().isEmpty());
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.findChildren<QLineEdit*>().isEmpty(); }));
    };
    type(6, " Leather ");
    type(3, "Wool");
    EXPECT_EQ(document.history().node(4).branch, "Leather");
    EXPECT_EQ(document.history().node(2).branch, "Wool");
    document.nameVersion(2, "Shown to the customer");
    keepPicture(panel, "history-branches");
    type(3, "Felt");
    EXPECT_EQ(document.history().node(2).branch, "Felt");
    EXPECT_EQ(document.history().node(2).name, "Shown to the customer");
    EXPECT_EQ(document.history().current(), 6) << "naming goes nowhere";

    // A name is no edit: undo leaves it alone, and what is edited next by double click is a version again.
    document.undo();
    document.jumpTo(3);
    EXPECT_EQ(document.history().node(4).branch, "Leather");
    const QPoint line = view.visualRect(view.history().indexOf(4)).center();
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, line);
    QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, line);
    auto* editor = view.findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    EXPECT_EQ(editor->text(), "") << "the version has no name";
    QTest::keyClick(editor, Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.findChildren<QLineEdit*>().isEmpty(); }));

    const auto shown = [&](NodeId node) { return !view.isRowHidden(view.history().indexOf(node).row()); };
    QTest::keyClicks(&panel.search(), "leath");
    EXPECT_TRUE(shown(4));
    EXPECT_FALSE(shown(2));
    view.nameBranchOf(3);
    EXPECT_TRUE(shown(2)) << "the line in which its name is asked for";
}

/// All that a history model says.
QStringList linesOf(const HistoryModel& model)
{
    QStringList lines;
    for (int row = 0; row < model.rowCount(); ++row) {
        QStringList line{model.index(row).data().toString()};
        for (int role = HistoryModel::NodeRole; role <= HistoryModel::BranchRole; ++role)
            line << model.index(row).data(role).toString();
        lines << line.join(u'|');
    }
    return lines;
}

TEST_F(HistoryTest, FollowingTheDocumentGivesTheSameLinesAsReadingItAnew)
{
    HistoryModel& model = view.history();
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    std::mt19937 random(1);
    const auto pick = [&](NodeId count) { return static_cast<NodeId>(random() % static_cast<unsigned>(count)); };
    for (int step = 0; step < 1'500; ++step) {
        switch (random() % 8) {
        case 0:
            document.undo();
            break;
        case 1:
            document.redo();
            break;
        case 2:
            document.jumpTo(pick(document.history().count()));
            break;
        case 3:
            document.nameVersion(pick(document.history().count()), "Version " + std::to_string(step));
            document.nameBranch(pick(document.history().count()), "Branch " + std::to_string(step));
            break;
        case 4:
            if (random() % 50 == 0)
                document.reset(twoSquares());
            break;
        default:
            rename(std::to_string(step).c_str());
        }
        ASSERT_EQ(linesOf(model), linesOf(HistoryModel(document))) << step;
        ASSERT_EQ(model.indexOf(document.history().current()).data(HistoryModel::CurrentRole), true);
    }
}

TEST_F(HistoryTest, AnEditAddsALineAndUndoAddsNone)
{
    int resets = 0;
    int inserted = 0;
    QObject::connect(view.model(), &QAbstractItemModel::modelReset, [&] { ++resets; });
    QObject::connect(view.model(), &QAbstractItemModel::rowsInserted,
                     [&](const QModelIndex&, int first, int last) { inserted += last - first + 1; });
    rename("One");
    rename("Two");
    EXPECT_EQ(inserted, 2);
    document.undo();
    document.redo();
    document.jumpTo(1);
    document.nameVersion(2, "Name");
    EXPECT_EQ(inserted, 2);
    EXPECT_EQ(resets, 0);
    rename("Three"); // a branch: lines move
    EXPECT_EQ(resets, 1);
}

TEST_F(HistoryTest, NamingAnotherVersionLeavesTheListWhereItIs)
{
    static QStringList said;
    said.clear();
    const QtMessageHandler before =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& text) { said << text; });
    view.edit(row(1));
    auto* editor = view.findChild<QLineEdit*>();
    if (editor) {
        QTest::keyClicks(editor, "With welt");
        QTest::keyClick(editor, Qt::Key_Return);
        (void)QTest::qWaitFor([&] { return view.findChildren<QLineEdit*>().isEmpty(); });
    }
    qInstallMessageHandler(before);
    EXPECT_EQ(document.history().node(1).name, "With welt");
    EXPECT_EQ(document.history().current(), 3);
    EXPECT_TRUE(said.isEmpty()) << qPrintable(said.join('\n'));
}

TEST_F(HistoryTest, ThePresentVersionStaysInSightWhenItGetsLower)
{
    for (int i = 0; i < 30; ++i)
        rename(std::to_string(i).c_str());
    const auto inSight = [&] {
        return view.viewport()->rect().contains(
            view.visualRect(view.history().indexOf(document.history().current())));
    };
    ASSERT_TRUE(QTest::qWaitFor(inSight));
    panel.resize(300, 160);
    EXPECT_TRUE(QTest::qWaitFor(inSight));

    view.scrollToTop(); // somebody looks elsewhere
    panel.resize(300, 140);
    QCoreApplication::processEvents();
    EXPECT_FALSE(inSight());
}

TEST_F(HistoryTest, NamingLeavesTheDesignAlone)
{
    const Design before = document.design();
    const std::uint64_t revision = document.revision();
    document.markSaved();
    document.nameVersion(3, "Final");
    document.nameVersion(99, "Nothing"); // there is no such version
    EXPECT_TRUE(document.design() == before);
    EXPECT_EQ(document.revision(), revision);
    EXPECT_TRUE(document.dirty()) << "the name is in no file";
}

} // namespace
} // namespace bolster
