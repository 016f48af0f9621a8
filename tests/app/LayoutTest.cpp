// The arrangement of the window.
#include "WindowTest.h"

#include "Inspector.h"
#include "MeshImport.h"
#include "SurfaceView.h"

#include <QSettings>

namespace bolster {
namespace {

TEST_F(WindowTest, TheArrangementIsTheSameAtEveryStart)
{
    window.actions().resetLayout->trigger();
    QTest::qWait(100);
    window.close(); // keeps the arrangement
    std::vector<int> heights;
    for (int start = 0; start < 4; ++start) {
        MainWindow again;
        again.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&again));
        QTest::qWait(200);
        heights.push_back(again.findChild<Inspector*>()->height());
        again.close();
    }
    for (const int height : heights)
        EXPECT_NEAR(height, heights.front(), 2);
    EXPECT_GT(heights.front(), 150);
}

TEST_F(WindowTest, ANewDesignHasNoSurfaceAndShowsItsFirstFrame)
{
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.solver().upToDate(); }, 10000));
    EXPECT_FALSE(window.solver().surface());
    const QString mesh = sample("armchair").replace("armchair.json", "armchair.obj");
    Frame frame;
    frame.scale = 1000;
    ASSERT_TRUE(window.session().addWithFile(mesh, {importMesh(mesh).mesh, nullptr}, frame).empty());
    QTest::qWait(500); // the view flies there
    const Camera& camera = window.surfaceView().camera();
    EXPECT_GT(camera.distance, 1500) << "the chair is 2 m wide";
    EXPECT_LT(camera.distance, 10000);
}

TEST_F(WindowTest, UndoTakesBackTheFirstDragOfAllWhileItGoesOn)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Design before = window.document().design();
    const ElementId patch = [&] {
        ElementId first{};
        before.each<Patch>([&](ElementId id, const Patch&) { first = first == ElementId{} ? id : first; });
        return first;
    }();
    window.selection().set({patch});
    const QPoint at = patternPixel(patch, 0);
    press(window.patternView(), at);
    move(window.patternView(), at + QPoint(20, 20), Qt::LeftButton);
    ASSERT_TRUE(window.document().gestureRunning());
    EXPECT_TRUE(window.actions().undo->isEnabled());
    window.actions().undo->trigger();
    EXPECT_FALSE(window.document().gestureRunning());
    EXPECT_TRUE(window.document().design() == before);
    release(window.patternView(), at + QPoint(20, 20));
    EXPECT_FALSE(window.document().dirty());
    EXPECT_FALSE(window.actions().undo->isEnabled());
}

} // namespace
} // namespace bolster
