// The arrangement of the window.
#include "WindowTest.h"

#include "CoverView.h"
#include "Inspector.h"
#include "MeshImport.h"
#include "SeamsModel.h"
#include "SeamsView.h"
#include "Theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QSettings>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

namespace bolster {
namespace {

/// How often the title of a part is to be read: above it, and on its tab.
qsizetype titlesOf(const MainWindow& window, const QDockWidget& dock)
{
    const QWidget* bar = dock.titleBarWidget();
    qsizetype count = bar->findChild<QLabel*>()->isVisible() && bar->height() > 0 ? 1 : 0;
    for (const QTabBar* tabs : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        for (int i = 0; tabs->isVisible() && i < tabs->count(); ++i)
            count += tabs->tabText(i) == dock.windowTitle() ? 1 : 0;
    return count;
}

void expectTitlesOnce(MainWindow& window, const char* when)
{
    for (const QDockWidget* dock : window.docks().all())
        if (!dock->isHidden()) {
            EXPECT_TRUE(QTest::qWaitFor([&] { return titlesOf(window, *dock) == 1; }))
                << when << ": " << qPrintable(dock->windowTitle()) << ' ' << titlesOf(window, *dock);
        }
}

TEST_F(WindowTest, ResettingTheLayoutSelectsNothing)
{
    ASSERT_TRUE(open(sample("armchair")));
    window.patternView().setFocus();
    Docks::reveal(window.docks().fabrics);
    window.command("window.reset-layout")->trigger();
    waitUntilLaidOut();
    EXPECT_TRUE(window.selection().elements().empty());
    EXPECT_TRUE(window.patternView().hasFocus()) << "who worked there goes on there";
}

TEST_F(WindowTest, EaseAndTheOrderOfSewingAreSeenInASmallWindow)
{
    window.command("window.reset-layout")->trigger();
    window.resize(1280, 800);
    ASSERT_TRUE(open(sample("car-seat")));
    Docks::reveal(window.docks().seams);
    waitUntilLaidOut();
    const QTreeView& table = window.seams().table();
    for (const auto column :
         {SeamsModel::Label, SeamsModel::Name, SeamsModel::Difference, SeamsModel::Ratio, SeamsModel::Step}) {
        const int left = table.header()->sectionViewportPosition(column);
        EXPECT_GE(left, 0) << column;
        EXPECT_LE(left + table.header()->sectionSize(column), table.viewport()->width()) << column;
    }
    window.command("window.reset-layout")->trigger(); // kept for other tests
}

TEST_F(WindowTest, ADockThatFloatsComesBackAfterTheWindow)
{
    window.command("window.reset-layout")->trigger();
    window.docks().inspector->setFloating(true);
    waitUntilLaidOut();
    window.close();
    MainWindow again;
    again.show();
    EXPECT_FALSE(again.docks().inspector->isFloating()) << "the window is not on the screen yet";
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&again));
    waitUntilLaidOut();
    EXPECT_TRUE(again.docks().inspector->isFloating());
    EXPECT_TRUE(again.docks().inspector->isVisible());
    again.command("window.reset-layout")->trigger(); // kept for other tests
    again.close();
}

TEST_F(WindowTest, EachPartSaysItsTitleOnce)
{
    window.command("window.reset-layout")->trigger();
    const Docks& docks = window.docks();
    expectTitlesOnce(window, "at first");
    for (QDockWidget* dock : {docks.history, docks.seams, docks.fabrics})
        dock->close();
    expectTitlesOnce(window, "alone");
    docks.seams->toggleViewAction()->trigger();
    expectTitlesOnce(window, "with one more");
    Docks::reveal(docks.spots);
    window.tabifyDockWidget(docks.pattern, docks.cover);
    window.tabifyDockWidget(docks.inspector, docks.spots);
    expectTitlesOnce(window, "with tabs");
    window.close();
    for (int start = 0; start < 2; ++start) {
        MainWindow again;
        again.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&again));
        waitUntilLaidOut();
        expectTitlesOnce(again, "after a start");
        if (start > 0)
            again.command("window.reset-layout")->trigger(); // kept for other tests
        again.close();
    }
}

TEST_F(WindowTest, TheArrangementIsTheSameAtEveryStart)
{
    window.command("window.reset-layout")->trigger();
    waitUntilLaidOut();
    window.close(); // keeps the arrangement
    std::vector<int> heights;
    for (int start = 0; start < 4; ++start) {
        MainWindow again;
        again.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&again));
        waitUntilLaidOut();
        heights.push_back(again.findChild<Inspector*>()->height());
        again.close();
    }
    for (const int height : heights)
        EXPECT_NEAR(height, heights.front(), 2);
    EXPECT_GT(heights.front(), 150);
}

TEST_F(WindowTest, ThePatternIsAsWideAtEveryStart)
{
    window.command("window.reset-layout")->trigger();
    waitUntilLaidOut();
    window.close();
    std::vector<int> widths;
    for (int start = 0; start < 4; ++start) {
        MainWindow again;
        again.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&again));
        again.open(sample("car-seat"));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !again.document().design().elements().empty(); }, 30000));
        again.selection().set({again.document().design().elements().begin()->first}); // other fields, other widths
        waitUntilLaidOut();
        widths.push_back(again.patternView().width());
        again.document().markSaved();
        again.close();
    }
    for (const int width : widths)
        EXPECT_NEAR(width, widths.front(), 2);
}

TEST_F(WindowTest, AWindowMadeSmallAndLargeAgainIsAsItWas)
{
    window.command("window.reset-layout")->trigger();
    waitUntilLaidOut();
    const auto sizes = [&] {
        QList<QSize> found;
        for (const QDockWidget* dock : {window.docks().pattern, window.docks().cover, window.docks().inspector})
            found << dock->size();
        return found;
    };
    const QSize large = window.size();
    const QList<QSize> before = sizes();
    for (const QSize small : {QSize(900, 600), QSize(1100, 500), QSize(700, 800)}) {
        window.resize(small);
        EXPECT_TRUE(QTest::qWaitFor([&] { return window.width() < large.width(); }));
        waitUntilLaidOut();
    }
    window.resize(large);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.size() == large; }));
    waitUntilLaidOut();
    const QList<QSize> after = sizes();
    for (qsizetype i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(after[i].width(), before[i].width(), 3) << i;
        EXPECT_NEAR(after[i].height(), before[i].height(), 3) << i;
    }
}

/// How often the parts of a window are laid out.
class Layouts : public QObject {
public:
    int count = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        count += event->type() == QEvent::LayoutRequest ? 1 : 0;
        return false;
    }
};

/// What the docks get is never quite what their share of a larger window would be.
TEST_F(WindowTest, ALargerWindowIsLaidOutOnce)
{
    window.command("window.reset-layout")->trigger();
    waitUntilLaidOut();
    window.resize(1500, 960);
    waitUntilLaidOut();
    Layouts layouts;
    window.installEventFilter(&layouts);
    waitUntilLaidOut();
    EXPECT_LE(layouts.count, 2);
    window.removeEventFilter(&layouts);
}

TEST_F(WindowTest, ImportantCommandsAreSeenInASmallWindowAndTheOthersHaveAButton)
{
    applyTheme(*qApp, Theme::Light);
    window.resize(1294, 800);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.width() == 1294; }));
    auto* bar = window.findChild<QToolBar*>(QStringLiteral("tools"));
    ASSERT_TRUE(bar);
    const auto seen = [&](QAction* action) {
        const QWidget* button = bar->widgetForAction(action);
        return button && button->isVisible() && bar->rect().contains(button->geometry());
    };
    for (QAction* action :
         window.commands().startingWith("tool.") +
             QList<QAction*>{window.command("file.save"), window.command("edit.undo"), window.command("edit.redo"),
                             window.command("surface.pause"), window.command("view.fit-all")})
        EXPECT_TRUE(seen(action)) << action->objectName().toStdString();

    window.resize(800, 600);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.width() == 800; }));
    auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    ASSERT_TRUE(more);
    EXPECT_TRUE(QTest::qWaitFor([&] { return more->isVisible(); }));
    EXPECT_GE(more->width(), 24);
    EXPECT_FALSE(more->icon().isNull());
    EXPECT_FALSE(more->toolTip().isEmpty());
    QTest::mouseClick(more, Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return seen(window.command("layer.grid")); }));
}

TEST_F(WindowTest, ANewDesignHasNoSurfaceAndShowsItsFirstFrame)
{
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.solver().upToDate(); }, 10000));
    EXPECT_FALSE(window.solver().surface());
    const QString mesh = sample("armchair").replace("armchair.json", "armchair.obj");
    Frame frame;
    frame.scale = 1000;
    ASSERT_TRUE(window.session().addWithFile(mesh, {importMesh(mesh).mesh, nullptr}, frame).empty());
    const Camera& camera = window.coverView().navigation().camera();
    EXPECT_TRUE(QTest::qWaitFor([&] { return camera.distance > 1500; })) << "the chair is 2 m wide";
    EXPECT_LT(camera.distance, 10000);
}

TEST_F(WindowTest, UndoTakesBackTheFirstDragOfAllWhileItGoesOn)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Design before = window.document().design();
    const ElementId patch = [&] {
        ElementId first{};
        before.each<Patch>([&](ElementId id, const Patch&) { first = first == noElement ? id : first; });
        return first;
    }();
    window.selection().set({patch});
    const QPoint at = patternPixel(patch, 0);
    press(window.patternView(), at);
    move(window.patternView(), at + QPoint(20, 20), Qt::LeftButton);
    ASSERT_TRUE(window.document().gestureRunning());
    EXPECT_TRUE(window.command("edit.undo")->isEnabled());
    window.command("edit.undo")->trigger();
    EXPECT_FALSE(window.document().gestureRunning());
    EXPECT_TRUE(window.document().design() == before);
    release(window.patternView(), at + QPoint(20, 20));
    EXPECT_FALSE(window.document().dirty());
    EXPECT_FALSE(window.command("edit.undo")->isEnabled());
}

} // namespace
} // namespace bolster
