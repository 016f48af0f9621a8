// Fixation curves made from the surface, and what the 3D window hides and remembers.
#include "Crosshair.h"
#include "SavedViews.h"
#include "WindowTest.h"

#include <QMenu>
#include <QMenuBar>

namespace bolster {
namespace {

constexpr ElementId top{2}, front{3};

class FixingTest : public WindowTest {
protected:
    int curveCount()
    {
        int count = 0;
        window.document().design().each<FixationCurve>([&](ElementId, const FixationCurve&) { ++count; });
        return count;
    }

    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
        ASSERT_TRUE(waitUntilSolved());
    }
};

TEST_F(FixingTest, TwoPointsOfAnOutlineGiveAFixationCurveWhereTheCoverIs)
{
    EXPECT_FALSE(window.command("fixation.create")->isEnabled());
    window.selection().set({top}, {{top, 0}, {top, 1}});
    ASSERT_TRUE(window.command("fixation.create")->isEnabled());
    const SurfaceMesh before = *window.solver().surface();
    QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(curveCount(), 2);
    const ElementId made = *window.selection().elements().begin();
    const BSpline3 curve = window.document().design().find<FixationCurve>(made)->curve;
    const SurfaceTopology& topology = *before.topology;
    int along = 0;
    for (std::uint32_t v = topology.patches[0].firstVertex; v < topology.patches[0].outlineCount; ++v)
        if (topology.pattern[v].y() == 0) {
            ++along;
            EXPECT_LT(curve.closest(before.positions[v]).distance, 0.5);
        }
    EXPECT_GT(along, 10);
    ASSERT_TRUE(waitUntilSolved());
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(curveCount(), 1) << "curve and seam are one edit";
}

TEST_F(FixingTest, WhatIsHiddenComesBack)
{
    window.selection().set({front});
    window.command("view.hide")->trigger();
    EXPECT_EQ(window.coverView().visibility().hidden(), std::set<ElementId>{front});
    EXPECT_TRUE(window.command("view.show-hidden")->isEnabled());
    window.selection().set({top});
    window.command("view.isolate")->trigger();
    EXPECT_FALSE(window.coverView().visibility().hidden().contains(top));
    EXPECT_TRUE(window.coverView().visibility().hidden().contains(front));
    window.command("view.show-hidden")->trigger();
    EXPECT_TRUE(window.coverView().visibility().hidden().empty());
    EXPECT_FALSE(window.document().dirty()) << "it is no part of the design";
}

TEST_F(FixingTest, TheViewsAreLinkedUntilTheyAreNot)
{
    auto* mark = window.coverView().findChild<Crosshair*>();
    const QPoint middle = patternPixel({250, 250});
    move(window.patternView(), middle, Qt::NoButton);
    EXPECT_TRUE(mark->isVisible());
    EXPECT_EQ(window.selection().hovered(), top);
    window.command("view.link")->trigger();
    EXPECT_FALSE(mark->isVisible());
    move(window.patternView(), middle + QPoint(3, 3), Qt::NoButton);
    EXPECT_FALSE(mark->isVisible());
    const Vec2 cover =
        *window.coverView().navigation().camera().pixel(window.solver().surface()->boundingBox().center());
    move(window.patternView(), {2, 2}, Qt::NoButton);
    move(window.coverView(), QPoint(static_cast<int>(cover.x()), static_cast<int>(cover.y())), Qt::NoButton);
    EXPECT_EQ(window.selection().hovered(), noElement) << "hovering stays in its view";
    window.command("view.link")->trigger();
    press(window.coverView(), QPoint(static_cast<int>(cover.x()), static_cast<int>(cover.y())));
    release(window.coverView(), QPoint(static_cast<int>(cover.x()), static_cast<int>(cover.y())));
    EXPECT_EQ(window.selection().elements().size(), 1u) << "what is selected is selected everywhere";
}

TEST_F(FixingTest, ViewsAreSavedByName)
{
    const QString name = QStringLiteral("Left & low / 1");
    SavedViews::save(name, window.coverView().navigation().camera());
    EXPECT_EQ(SavedViews::names(), QStringList{name});
    const auto found = SavedViews::find(name);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->azimuth, window.coverView().navigation().camera().azimuth);
    window.coverView().navigation().setStandardView(CoverView::StandardView::Top);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.coverView().navigation().camera().elevation > 1.5; }));
    auto* menu = window.menuBar()->findChild<QMenu*>(QStringLiteral("view.saved"));
    emit menu->aboutToShow();
    menu->actions().front()->trigger();
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return std::abs(window.coverView().navigation().camera().elevation - found->elevation) < 1e-9; }));
    SavedViews::remove(name);
    EXPECT_TRUE(SavedViews::names().isEmpty());
    EXPECT_FALSE(SavedViews::find(name));
}

TEST_F(FixingTest, LastViewsAreKeptOfTheLatestFiles)
{
    const QTemporaryDir folder;
    const auto file = [&](int i) { return folder.filePath(QStringLiteral("a b %1.bolster").arg(i)); };
    constexpr int count = 60;
    for (int i = 0; i < count; ++i) {
        QFile made(file(i));
        ASSERT_TRUE(made.open(QFile::WriteOnly));
        Viewpoint view;
        view.distance = 100 + i;
        SavedViews::keepLast(file(i), view);
        ASSERT_TRUE(SavedViews::lastOf(file(i)));
        EXPECT_EQ(SavedViews::lastOf(file(i))->distance, 100 + i);
    }
    EXPECT_FALSE(SavedViews::lastOf(file(0))) << "long ago";
    EXPECT_TRUE(SavedViews::lastOf(file(count - 50)));
    EXPECT_FALSE(SavedViews::lastOf(folder.filePath("missing"))) << "never seen";
    EXPECT_FALSE(SavedViews::lastOf({}));
}

TEST_F(FixingTest, TheSectionIsSwitchedInTheMenuAndInItsPanel)
{
    window.command("view.section")->trigger();
    EXPECT_TRUE(window.coverView().shown().scene().section);
    emit window.coverView().sectionClosed();
    EXPECT_FALSE(window.command("view.section")->isChecked());
    EXPECT_FALSE(window.coverView().shown().scene().section);
}

} // namespace
} // namespace bolster
