// Names that look like HTML are names.
#include "WindowTest.h"

#include "ElementEdits.h"
#include "ElementsModel.h"
#include "ElementsView.h"
#include "HistoryModel.h"
#include "HistoryView.h"
#include "PictureTip.h"

#include <QBuffer>
#include <QDir>
#include <QLabel>
#include <QStandardPaths>
#include <QToolTip>
#include <QTreeView>

namespace bolster {
namespace {

class PlainTextTest : public WindowTest {
protected:
    ~PlainTextTest() override
    {
        QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/journals")
            .removeRecursively();
    }

    static QLabel* tip()
    {
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (widget->inherits("QTipLabel") && widget->isVisible())
                return qobject_cast<QLabel*>(widget);
        return nullptr;
    }

    static void hover(QAbstractItemView& view, const QModelIndex& index)
    {
        const QPoint place = view.visualRect(index).center();
        QHelpEvent help(QEvent::ToolTip, place, view.viewport()->mapToGlobal(place));
        QApplication::sendEvent(view.viewport(), &help);
    }
};

TEST_F(PlainTextTest, ATipShowsANameAsItIs)
{
    // As HTML this would be read from the disk; a pipe would be waited for.
    const QString name = "<img src=\"file:///dev/null\" width=900 height=900> a name that is too long for its row";
    ASSERT_TRUE(open(sample("box-cushion")));
    const ElementId patch = window.document().design().elements().begin()->first;
    window.document().commit(edits::renameElement(window.document().design(), patch, name.toStdString()));
    auto* tree = window.findChild<ElementsView*>()->findChild<QTreeView*>();
    ASSERT_TRUE(tree);
    tree->expandAll();
    const QModelIndexList rows = tree->model()->match(tree->model()->index(0, 0), Qt::DisplayRole, name, 1,
                                                      Qt::MatchContains | Qt::MatchRecursive);
    ASSERT_EQ(rows.size(), 1);
    tree->scrollTo(rows[0]);
    hover(*tree, rows[0]);
    ASSERT_TRUE(QTest::qWaitFor([] { return tip() != nullptr; }));
    EXPECT_EQ(tip()->textFormat(), Qt::PlainText);
    EXPECT_TRUE(tip()->text().contains("<img")) << qPrintable(tip()->text());
    EXPECT_LT(tip()->height(), 200);
    QToolTip::hideText();
}

TEST_F(PlainTextTest, BoxesTakeNamesAsTheyAre)
{
    QString format;
    whenABoxHas([&](QMessageBox& box) {
        for (const QLabel* label : box.findChildren<QLabel*>())
            if (label->text().contains("<b>"))
                format = label->textFormat() == Qt::PlainText ? "plain" : "rich";
        return box.button(QMessageBox::Ok);
    });
    window.open(QDir::temp().filePath("<b>none</b>.bolster"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !format.isEmpty(); }, 30000));
    EXPECT_EQ(format, "plain");
}

TEST_F(PlainTextTest, TheHistoryShowsItsPicturesStill)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    auto* view = window.findChild<HistoryView*>();
    view->history().setPictures([](NodeId) {
        QByteArray png;
        QBuffer buffer(&png);
        QImage picture(320, 240, QImage::Format_RGB32);
        picture.fill(Qt::red);
        picture.save(&buffer, "PNG");
        return png;
    });
    hover(*view, view->model()->index(0, 0));
    auto* shown = view->findChild<PictureTip*>();
    ASSERT_TRUE(shown);
    EXPECT_TRUE(shown->isVisible());
    EXPECT_GT(shown->width(), 320);
    EXPECT_GT(shown->height(), 240);
    QTest::mouseMove(&window.patternView(), QPoint(50, 50));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !shown->isVisible(); }));
}

} // namespace
} // namespace bolster
