// Editing patches by menu, clipboard and the split tool.
#include "WindowTest.h"

#include "ElementEdits.h"
#include "ElidedLabel.h"
#include "LayoutEdits.h"
#include "StatusLine.h"

#include <QClipboard>
#include <QMimeData>

namespace bolster {
namespace {

class PatternTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample("box-cushion")));
        window.patternView().setFocus();
    }

    const Design& design() { return window.document().design(); }
    ElementId patchNamed(const std::string& name)
    {
        ElementId found{};
        design().each<Patch>([&](ElementId id, const Patch& patch) { found = patch.name == name ? id : found; });
        return found;
    }
    int patchCount()
    {
        int count = 0;
        design().each<Patch>([&](ElementId, const Patch&) { ++count; });
        return count;
    }
    void click(QPoint at)
    {
        move(window.patternView(), at, Qt::NoButton);
        press(window.patternView(), at);
        release(window.patternView(), at);
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&window.patternView(), key, modifiers);
    }
};

TEST_F(PatternTest, DuplicatesCopiesAndPastes)
{
    const Design before = design();
    const ElementId top = patchNamed("Top");
    EXPECT_FALSE(window.command("edit.copy")->isEnabled());
    window.selection().set({top});
    key(Qt::Key_D, Qt::ControlModifier);
    ASSERT_EQ(patchCount(), 6);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{patchNamed("Top 2")});
    window.command("edit.undo")->trigger();
    EXPECT_EQ(design(), before);

    window.selection().set({top});
    window.command("edit.copy")->trigger();
    EXPECT_TRUE(QGuiApplication::clipboard()->text().contains("bolster-design"));
    EXPECT_TRUE(
        QGuiApplication::clipboard()->mimeData()->hasFormat(QStringLiteral("application/x-bolster-design+json")));
    ASSERT_TRUE(window.command("edit.paste")->isEnabled());
    window.command("edit.paste")->trigger();
    window.command("edit.paste")->trigger();
    ASSERT_EQ(patchCount(), 7);
    const Patch &second = *design().find<Patch>(patchNamed("Top 2")),
                &third = *design().find<Patch>(patchNamed("Top 3"));
    EXPECT_NE(second.position, before.find<Patch>(top)->position) << "else it would hide the first one";
    EXPECT_NE(second.position, third.position);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{patchNamed("Top 3")});

    window.command("edit.cut")->trigger();
    EXPECT_EQ(patchCount(), 6);
    window.command("edit.paste")->trigger();
    EXPECT_EQ(patchCount(), 7) << "it comes back";
}

TEST_F(PatternTest, MirrorsAlignsAndArranges)
{
    const ElementId top = patchNamed("Top"), right = patchNamed("Right"), front = patchNamed("Front");
    window.selection().set({top});
    EXPECT_FALSE(window.command("layout.align-left")->isEnabled());
    window.command("layout.mirror-horizontally")->trigger();
    EXPECT_LT(design().find<Patch>(top)->outline.signedArea(), 0);
    window.selection().set({top, right, front});
    window.command("layout.align-left")->trigger();
    const auto left = [&](ElementId id) { return edits::layoutBox(*design().find<Patch>(id)).min().x(); };
    EXPECT_NEAR(left(top), left(right), 1e-6);
    EXPECT_TRUE(window.command("layout.distribute-horizontally")->isEnabled());
    window.selection().clear();
    window.command("layout.arrange")->trigger();
    EXPECT_GT(std::abs(left(top) - left(right)), 1);
}

TEST_F(PatternTest, MakesCornersSmoothAndBack)
{
    const ElementId top = patchNamed("Top");
    window.selection().set({top}, {{top, 2}});
    EXPECT_FALSE(window.command("shape.make-corner")->isEnabled());
    ASSERT_TRUE(window.command("shape.make-smooth")->isEnabled());
    window.command("shape.make-smooth")->trigger();
    EXPECT_EQ(design().find<Patch>(top)->outline.degree(), 3);
    ASSERT_EQ(window.selection().points().size(), 1u) << "the point stays selected";
    const int point = window.selection().points().begin()->second;
    EXPECT_EQ(design().find<Patch>(top)->outline.points()[static_cast<std::size_t>(point)], Vec2(500, 500));
    ASSERT_TRUE(window.command("shape.make-corner")->isEnabled());
    window.command("shape.make-corner")->trigger();
    EXPECT_EQ(design().find<Patch>(top)->outline.corners().size(), 4u);
}

TEST_F(PatternTest, SplitsByDrawingAndMergesAgain)
{
    const Design before = design();
    const ElementId top = patchNamed("Top");
    key(Qt::Key_K);
    ASSERT_EQ(window.patternView().tool(), PatternToolKind::Split);
    click(patternPixel(Vec2(-20, 200)));
    click(patternPixel(Vec2(250, 260)));
    key(Qt::Key_Return);
    EXPECT_EQ(patchCount(), 5) << "the line does not reach the other side";
    click(patternPixel(Vec2(520, 200)));
    key(Qt::Key_Return);
    ASSERT_EQ(patchCount(), 6);
    const ElementId piece = patchNamed("Top 2");
    EXPECT_EQ(window.selection().elements(), (Selection::Elements{top, piece}));
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }, 5000));
    EXPECT_NE(window.command("edit.undo")->text().indexOf("Top"), -1);

    ASSERT_TRUE(window.command("shape.merge-patches")->isEnabled());
    window.command("shape.merge-patches")->trigger();
    EXPECT_EQ(patchCount(), 5);
    window.command("edit.undo")->trigger();
    window.command("edit.undo")->trigger();
    EXPECT_EQ(design(), before);
}

TEST_F(PatternTest, ACutOverBothArmsOfAUSaysWhatIsWrong)
{
    Patch arms = *design().find<Patch>(patchNamed("Top"));
    arms.name = "Arms";
    arms.position = {2000, 0};
    arms.outline =
        BSpline2(1, true, {{0, 0}, {300, 0}, {300, 300}, {200, 300}, {200, 100}, {100, 100}, {100, 300}, {0, 300}});
    window.document().commit(edits::addElement(design(), makeElement(arms)));
    window.command("view.fit-all")->trigger();
    const int before = patchCount();
    key(Qt::Key_K);
    click(patternPixel(Vec2(1980, 250)));
    click(patternPixel(Vec2(2320, 250))); // the middle of the line lies between the arms
    key(Qt::Key_Return);
    EXPECT_EQ(patchCount(), before);
    const auto words = window.statusLine().findChildren<ElidedLabel*>();
    EXPECT_TRUE(std::ranges::any_of(words, [](const ElidedLabel* label) {
        return label->fullText() == "The line must cross the outline of Arms exactly twice, not 4 times.";
    }));
}

TEST_F(PatternTest, WhatAnEditTakesAwayBesidesIsSaidUntilTheNextOne)
{
    key(Qt::Key_K);
    click(patternPixel(Vec2(-20, 200)));
    click(patternPixel(Vec2(520, 200)));
    key(Qt::Key_Return);
    const ElementId piece = patchNamed("Top 2");
    FixationSeam held;
    held.orientation.directions = {Vec3(0, 0, 1)};
    design().each<Seam>([&](ElementId, const Seam& seam) {
        if (seam.a.patch == piece && seam.b.patch == patchNamed("Top"))
            held.stretch = seam.a;
        if (seam.b.patch == piece && seam.a.patch == patchNamed("Top"))
            held.stretch = seam.b;
    });
    ASSERT_EQ(held.stretch.patch, piece);
    const Edit add = edits::addElement(design(), makeElement(held));
    window.document().commit(add);
    const Design before = design();
    ASSERT_TRUE(design().element(add.changes.front().id));
    EXPECT_FALSE(window.banner().shown());

    window.selection().set({patchNamed("Top"), piece});
    window.command("shape.merge-patches")->trigger();
    EXPECT_EQ(patchCount(), 5);
    ASSERT_FALSE(design().element(add.changes.front().id));
    ASSERT_TRUE(window.banner().shown());
    EXPECT_TRUE(window.banner().text().startsWith("This change has taken away"))
        << window.banner().text().toStdString();
    const QList<QPushButton*> buttons = window.banner().findChildren<QPushButton*>();
    ASSERT_EQ(buttons.size(), 1);
    buttons.front()->click();
    EXPECT_EQ(design(), before);
    EXPECT_FALSE(window.banner().shown());

    window.selection().set({patchNamed("Top"), piece});
    window.command("shape.merge-patches")->trigger();
    ASSERT_TRUE(window.banner().shown());
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(window.banner().shown());
}

TEST_F(PatternTest, EscapeTakesBackTheCutThenTheTool)
{
    const Design before = design();
    key(Qt::Key_K);
    click(patternPixel(Vec2(-20, 200)));
    click(patternPixel(Vec2(520, 200)));
    key(Qt::Key_Escape);
    EXPECT_EQ(window.patternView().tool(), PatternToolKind::Split);
    key(Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }, 5000));
    EXPECT_EQ(design(), before);
}

TEST_F(PatternTest, AnImpossibleDragIsNeitherSolvedNorKept)
{
    ASSERT_TRUE(waitUntilSolved());
    const Design before = design();
    const ElementId top = patchNamed("Top");
    PatternView& view = window.patternView();
    const auto status = [this] { return window.statusBar()->findChild<ElidedLabel*>()->fullText(); };
    window.selection().set({top});
    view.navigation().fitSelection();
    view.aids().setSnapping(false);
    const QPoint from = patternPixel(top, 0), across = patternPixel(top, 2) + QPoint(60, 10);
    move(view, from, Qt::NoButton);
    press(view, from);
    move(view, (from + across) / 2, Qt::LeftButton);
    move(view, across, Qt::LeftButton);
    ASSERT_TRUE(window.document().breakage());
    EXPECT_TRUE(status().startsWith(QStringLiteral("The outline of Top would cross or touch itself.")))
        << status().toStdString();
    ASSERT_TRUE(QTest::qWaitFor([this] { return window.solver().status().state == SolverStatus::State::Settled; }));
    EXPECT_FALSE(window.solver().upToDate()) << "it is not asked";
    EXPECT_TRUE(window.solver().surface()) << "the last good one stays";
    release(view, across);
    EXPECT_EQ(design(), before);
    EXPECT_EQ(window.document().history().count(), 1);
    EXPECT_TRUE(status().endsWith(QStringLiteral("It is back where it was."))) << status().toStdString();
    EXPECT_TRUE(waitUntilSolved());
}

} // namespace
} // namespace bolster
