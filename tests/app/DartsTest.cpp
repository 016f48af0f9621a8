// A designer cuts, drags and rotates darts in the real window.
#include "WindowTest.h"

#include "CutPattern.h"
#include "DartEdits.h"
#include "SeamTruing.h"
#include "Selection.h"

#include <QCheckBox>

#include <algorithm>
#include <cmath>

namespace bolster {
namespace {

class DartsTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample("box-cushion")));
        design().each<Patch>([&](ElementId id, const Patch& patch) {
            if (patch.name == "Top")
                top = id;
        });
        window.selection().set({top});
        window.patternView().navigation().fitSelection();
        window.selection().clear();
    }

    const Design& design() { return window.document().design(); }
    const Patch& patch() { return *design().find<Patch>(top); }

    /// Of the outline of the top, which is 500 mm wide and deep.
    QPoint at(double x, double y) { return patternPixel(toLayout(patch(), {x, y})); }

    void click(QPoint pixel)
    {
        move(window.patternView(), pixel, Qt::NoButton);
        press(window.patternView(), pixel);
        release(window.patternView(), pixel);
    }

    void drag(QPoint from, QPoint to)
    {
        move(window.patternView(), from, Qt::NoButton);
        press(window.patternView(), from);
        move(window.patternView(), (from + to) / 2, Qt::LeftButton);
        move(window.patternView(), to, Qt::LeftButton);
        release(window.patternView(), to);
    }

    void key(int code) { QTest::keyClick(&window.patternView(), static_cast<Qt::Key>(code)); }
    void type(const char* text)
    {
        QTest::keyClicks(&window.patternView(), QString::fromUtf8(text));
        key(Qt::Key_Return);
    }

    std::vector<std::pair<ElementId, edits::DartShape>> darts()
    {
        std::vector<std::pair<ElementId, edits::DartShape>> found;
        design().each<Seam>([&](ElementId id, const Seam&) {
            if (const auto dart = edits::dartOf(design(), id))
                found.emplace_back(id, *dart);
        });
        return found;
    }

    /// 20 mm wide in the middle of the lower edge, 100 mm deep.
    void cutOne()
    {
        window.command("tool.dart")->trigger();
        click(at(240, 0));
        move(window.patternView(), at(300, 0), Qt::NoButton);
        type("20");
        move(window.patternView(), at(250, 60), Qt::NoButton);
        type("100");
        ASSERT_EQ(darts().size(), 1u);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    }

    ElementId top{};
};

TEST_F(DartsTest, AreCutByThreeClicks)
{
    const Design before = design();
    EXPECT_EQ(window.command("tool.dart")->shortcut(), QKeySequence(Qt::SHIFT | Qt::Key_D));
    window.command("tool.dart")->trigger();
    ASSERT_EQ(window.patternView().tool(), PatternToolKind::Dart);
    click(at(230, 0));
    click(at(262, 0));
    click(at(248, 90));
    ASSERT_EQ(darts().size(), 1u);
    const auto [id, dart] = darts().front();
    EXPECT_EQ(dart.patch, top);
    EXPECT_TRUE(window.selection().contains(id)) << "to go on with it";
    const BSpline2& outline = patch().outline;
    EXPECT_NEAR((dart.tip - outline.at(dart.from)).norm(), (dart.tip - outline.at(dart.to)).norm(), 1e-6)
        << "near the axis the legs become equally long";
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    window.command("edit.undo")->trigger();
    EXPECT_EQ(design(), before);
}

TEST_F(DartsTest, HaveTheTypedWidthAndDepth)
{
    cutOne();
    const auto [id, dart] = darts().front();
    const BSpline2& outline = patch().outline;
    const Vec2 a = outline.at(dart.from), b = outline.at(dart.to);
    EXPECT_NEAR((b - a).norm(), 20, 1e-6);
    EXPECT_NEAR(((a + b) / 2 - dart.tip).norm(), 100, 1e-6);
}

TEST_F(DartsTest, EscapeTakesBackAClickAndThenTheTool)
{
    const Design before = design();
    window.command("tool.dart")->trigger();
    click(at(230, 0));
    click(at(262, 0));
    key(Qt::Key_Escape);
    click(at(290, 0)); // the mouth's end again
    click(at(260, -80));
    EXPECT_EQ(design(), before) << "the tip lies outside";
    EXPECT_EQ(window.patternView().tool(), PatternToolKind::Dart) << "and can be clicked again";
    for (int step = 0; step < 3; ++step)
        key(Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    EXPECT_EQ(design(), before);
}

TEST_F(DartsTest, AreSelectedWhereTheyWereCutAndNotInTheTwin)
{
    window.selection().set({top});
    window.command("twin.make")->trigger();
    window.selection().clear();
    window.command("tool.dart")->trigger();
    click(at(230, 0));
    click(at(262, 0));
    click(at(248, 90));
    ASSERT_EQ(darts().size(), 2u);
    for (const auto& [id, dart] : darts())
        EXPECT_EQ(window.selection().contains(id), dart.patch == top);
}

TEST_F(DartsTest, AreDraggedByTipAndMouth)
{
    cutOne();
    const auto [id, before] = darts().front();
    const Design cut = design();
    // The tip: near the axis it keeps both legs equal.
    drag(patternPixel(toLayout(patch(), before.tip)), at(261, 180));
    ASSERT_EQ(darts().size(), 1u);
    edits::DartShape now = darts().front().second;
    EXPECT_EQ(darts().front().first, id);
    EXPECT_NEAR(now.tip.x(), before.tip.x(), 1e-6) << "it snaps to the axis";
    EXPECT_NEAR(now.tip.y(), 180, 2);
    EXPECT_TRUE(window.selection().contains(id));
    // Beyond the other edge it cannot be: it stays where it could.
    drag(patternPixel(toLayout(patch(), now.tip)), at(260, 560));
    EXPECT_TRUE(darts().front().second.tip.y() < 500);
    // The mouth along the outline.
    now = darts().front().second;
    const Vec2 mouth = (patch().outline.at(now.from) + patch().outline.at(now.to)) / 2;
    drag(patternPixel(toLayout(patch(), mouth)), at(mouth.x() + 100, mouth.y()));
    ASSERT_EQ(darts().size(), 1u);
    EXPECT_EQ(darts().front().first, id) << "the seam that it was";
    EXPECT_NEAR(darts().front().second.tip.x(), now.tip.x() + 100, 2);
    EXPECT_NEAR(darts().front().second.tip.y(), now.tip.y(), 1e-3);
    while (design() != cut && window.command("edit.undo")->isEnabled())
        window.command("edit.undo")->trigger();
    EXPECT_EQ(design(), cut);
}

TEST_F(DartsTest, AreAsDeepAndAsFarFromTheCornerAsIsTypedWhileTheyAreDragged)
{
    cutOne();
    const Vec2 tip = darts().front().second.tip;
    PatternView& view = window.patternView();
    const QPoint grabbed = patternPixel(toLayout(patch(), tip));
    move(view, grabbed, Qt::NoButton);
    press(view, grabbed);
    move(view, grabbed + QPoint(30, -20), Qt::LeftButton);
    type("137.5");
    release(view, grabbed + QPoint(30, -20));
    const auto axisOf = [&] { return edits::dartAxis(patch().outline, darts().front().second); };
    EXPECT_NEAR((darts().front().second.tip - axisOf().middle).norm(), 137.5, 1e-6);
    EXPECT_NEAR(darts().front().second.tip.x(), tip.x(), 1e-6) << "both legs are of one length";

    // The mouth: from the corner on whose side the pointer is.
    const QPoint mouth = at(axisOf().middle.x(), axisOf().middle.y());
    move(view, mouth, Qt::NoButton);
    press(view, mouth);
    move(view, at(330, 0), Qt::LeftButton);
    move(view, at(350, 0), Qt::LeftButton);
    type("120");
    release(view, at(350, 0));
    EXPECT_NEAR(axisOf().middle.x(), 500 - 120, 1e-6);
    EXPECT_NEAR(axisOf().middle.y(), 0, 1e-6);
    // What there is no room for is not taken, and Escape gives up what is typed first.
    const edits::DartShape before = darts().front().second;
    const QPoint there = at(380, 0);
    press(view, there);
    move(view, at(390, 0), Qt::LeftButton);
    move(view, at(400, 0), Qt::LeftButton);
    QTest::keyClicks(&view, QStringLiteral("9999"));
    key(Qt::Key_Escape);
    EXPECT_NEAR(axisOf().middle.x(), 400, 2) << "it follows the pointer again";
    key(Qt::Key_Escape);
    release(view, at(400, 0));
    EXPECT_TRUE(darts().front().second.tip.isApprox(before.tip, 1e-9));
}

TEST_F(DartsTest, AreClosedIntoAnEdge)
{
    const Design before = design();
    const std::size_t seams = before.elements().size();
    EXPECT_FALSE(window.command("dart.close")->isEnabled()) << "no dart is selected";
    cutOne();
    ASSERT_TRUE(window.command("dart.close")->isEnabled());
    window.command("dart.close")->trigger();
    EXPECT_TRUE(darts().empty());
    EXPECT_NEAR(patch().outline.signedArea(), before.find<Patch>(top)->outline.signedArea(), 1e-6);
    EXPECT_EQ(design().elements().size(), seams) << "what was sewn to the edge is one seam again";
    EXPECT_EQ(patch().outline.pointCount(), before.find<Patch>(top)->outline.pointCount())
        << "no corners are left of the mouth";
    EXPECT_TRUE(window.selection().contains(top));
}

TEST_F(DartsTest, AreRotatedToAnotherEdge)
{
    cutOne();
    const ElementId id = darts().front().first;
    const double area = patch().outline.signedArea();
    ASSERT_TRUE(window.command("dart.rotate")->isEnabled());
    window.command("dart.rotate")->trigger();
    click(at(250, 100)); // the tip, no outline of another edge: the nearest place is its own leg
    EXPECT_EQ(window.patternView().tool(), PatternToolKind::DartRotation) << "said why not";
    click(at(500, 252));
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    ASSERT_EQ(darts().size(), 1u);
    EXPECT_EQ(darts().front().first, id);
    EXPECT_NEAR(patch().outline.signedArea(), area, 1e-6);
    const edits::DartShape dart = darts().front().second;
    const Vec2 one = patch().outline.at(dart.from) - dart.tip, two = patch().outline.at(dart.to) - dart.tip;
    EXPECT_NEAR(std::acos(one.dot(two) / one.norm() / two.norm()), 2 * std::atan2(10, 100), 1e-6);
    EXPECT_TRUE(window.selection().contains(id));
}

TEST_F(DartsTest, TheirMouthsAreTrued)
{
    cutOne();
    const ElementId id = darts().front().first;
    const Seam seam = *design().find<Seam>(id);
    const bool first = patch().outline.at(seam.a.from) != darts().front().second.tip;
    ASSERT_LT(std::abs(*edits::kinkAtSeamEnd(design(), seam, first)), 20);
    ASSERT_GT(std::abs(*edits::kinkAtSeamEnd(design(), seam, first)), 5);
    ASSERT_TRUE(window.command("shape.common-tangents")->isEnabled());
    window.command("shape.common-tangents")->trigger();
    EXPECT_NEAR(*edits::kinkAtSeamEnd(design(), *design().find<Seam>(id), first), 0, 1e-6);
    window.command("edit.undo")->trigger();
    EXPECT_GT(std::abs(*edits::kinkAtSeamEnd(design(), seam, first)), 5);
}

TEST_F(DartsTest, LabelsAreDraggedAndGoBack)
{
    window.command("layer.cutting")->setChecked(true);
    const auto piece = [&]() -> const CutPiece* {
        const auto& cut = window.patternView().shown().cut();
        if (!cut)
            return nullptr;
        const auto found = std::ranges::find(cut->pieces, top, &CutPiece::patch);
        return found == cut->pieces.end() ? nullptr : &*found;
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return piece() != nullptr; }, 30000));
    // So near that labels can be read.
    const Vec2 middle = piece()->label.at;
    Box2 near(toLayout(patch(), middle - Vec2(120, 120)));
    near.extend(toLayout(patch(), middle + Vec2(120, 120)));
    PatternView& view = window.patternView();
    view.navigation().setTransform(PatternTransform::fitting(near, view.size(), 0));
    const Design before = design();
    drag(patternPixel(toLayout(patch(), middle)), patternPixel(toLayout(patch(), middle + Vec2(60, 45))));
    ASSERT_TRUE(patch().cutting.label);
    EXPECT_NEAR(patch().cutting.label->position.x(), middle.x() + 60, 1);
    EXPECT_NEAR(patch().cutting.label->position.y(), middle.y() + 45, 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return (piece()->label.at - patch().cutting.label->position).norm() < 1e-6; },
                                30000));
    // The properties say so, and put it back.
    window.selection().set({top});
    QCheckBox* automatic = nullptr;
    for (QCheckBox* box : window.findChildren<QCheckBox*>())
        if (box->text() == QStringLiteral("Label where it finds room"))
            automatic = box;
    ASSERT_TRUE(automatic);
    EXPECT_FALSE(automatic->isChecked());
    automatic->click();
    EXPECT_EQ(design(), before);
    window.command("edit.undo")->trigger();
    ASSERT_TRUE(patch().cutting.label);
    window.command("edit.undo")->trigger();
    EXPECT_EQ(design(), before) << "one step";
}

} // namespace
} // namespace bolster
