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

TEST_F(HistoryTest, NamingLeavesTheDesignAlone)
{
    const Design before = document.design();
    const std::uint64_t revision = document.revision();
    document.markSaved();
    document.nameVersion(3, "Final");
    document.nameVersion(99, "Nothing"); // there is no such version
    EXPECT_TRUE(document.design() == before);
    EXPECT_EQ(document.revision(), revision);
    EXPECT_FALSE(document.dirty());
}

} // namespace
} // namespace bolster
