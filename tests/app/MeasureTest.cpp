// Measuring in both views, and measurements that are kept.
#include "CoverMeasures.h"
#include "Designer.h"
#include "WindowTest.h"

namespace bolster {
namespace {

class MeasureTest : public WindowTest {
protected:
    Designer designer{window};

    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
        ASSERT_TRUE(waitUntilAtRest());
    }

    PatternView& pattern() { return window.patternView(); }
    CoverView& cover() { return window.coverView(); }

    /// The highest place of the cover, and one beside it.
    std::pair<Vec3, Vec3> twoPlaces()
    {
        const std::vector<Vec3>& positions = window.solver().surface()->positions;
        const Vec3 top = *std::ranges::max_element(positions, {}, [](const Vec3& at) { return at.z(); });
        const Vec3 aside = *std::ranges::min_element(
            positions, {}, [&](const Vec3& at) { return (at - top - Vec3(100, 50, -5)).squaredNorm(); });
        return {top, aside};
    }
};

TEST_F(MeasureTest, GoesOnInBothViewsAndEndsInBoth)
{
    window.command("tool.measure")->trigger();
    EXPECT_EQ(pattern().tool(), PatternToolKind::Measure);
    EXPECT_EQ(cover().tool(), CoverToolKind::Measure);
    EXPECT_TRUE(window.command("tool.measure")->isChecked());
    window.command("tool.measure")->trigger();
    EXPECT_EQ(pattern().tool(), PatternToolKind::Select);
    EXPECT_EQ(cover().tool(), CoverToolKind::Select);

    window.command("tool.measure")->trigger();
    window.command("tool.draw-fixation")->trigger();
    EXPECT_EQ(pattern().tool(), PatternToolKind::Select);
    EXPECT_EQ(cover().tool(), CoverToolKind::DrawFixation);
    EXPECT_FALSE(window.command("tool.measure")->isChecked());
    window.command("tool.measure")->trigger();
    EXPECT_EQ(cover().tool(), CoverToolKind::Measure);
    takeKeyboard();
    cover().setFocus();
    designer.key(Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return cover().tool() == CoverToolKind::Select; }));
    EXPECT_EQ(pattern().tool(), PatternToolKind::Select);
}

TEST_F(MeasureTest, WhatIsMeasuredOnTheCoverIsKeptAndFollowsIt)
{
    cover().navigation().setStandardView(CoverView::StandardView::Top);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return cover().navigation().camera().backward().isApprox(Vec3(0, 0, 1), 1e-9); }, 10000));
    window.command("tool.measure")->trigger();
    const auto [from, to] = twoPlaces();
    designer.clickCover(from);
    designer.clickCover(to);
    EXPECT_TRUE(cover().prompt().contains(QStringLiteral("Enter"))) << cover().prompt().toStdString();
    takeKeyboard();
    cover().setFocus();
    designer.key(Qt::Key_Return);
    ASSERT_EQ(window.document().design().count<Measurement>(), 1);
    const ElementId kept = *window.selection().elements().begin();
    const Measurement measured = *window.document().design().find<Measurement>(kept);
    const auto length = [&] {
        const auto a = cover().shown().onCover({measured.from.patch, measured.from.position});
        const auto b = cover().shown().onCover({measured.to.patch, measured.to.position});
        return a && b ? (*b - *a).norm() : 0;
    };
    EXPECT_NEAR(length(), (to - from).norm(), 2) << "a pixel or so";
    auto* lines = cover().findChild<CoverMeasures*>();
    ASSERT_TRUE(lines);
    EXPECT_TRUE(lines->isVisible());
    EXPECT_EQ(lines->size(), cover().size());

    const double before = length();
    Patch patch = *window.document().design().find<Patch>(measured.from.patch);
    patch.pressure += 3;
    window.document().commit({{}, {{measured.from.patch, nullptr, makeElement(patch)}}});
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(length() - before) > 0.01; }, 60000))
        << "of the cover as it is now";

    window.command("tool.select")->trigger();
    window.selection().clear();
    designer.clickCover(0.4 * from + 0.6 * to);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{kept}) << "by its line";

    window.command("layer.measurements")->setChecked(false);
    EXPECT_FALSE(lines->isVisible());
    window.command("layer.measurements")->setChecked(true);
    EXPECT_TRUE(lines->isVisible());
    takeKeyboard();
    pattern().setFocus();
    designer.key(Qt::Key_Delete);
    EXPECT_EQ(window.document().design().count<Measurement>(), 0);
    EXPECT_FALSE(lines->isVisible());
}

} // namespace
} // namespace bolster
