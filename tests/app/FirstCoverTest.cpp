// What docs/first-cover.md promises.
#include "FirstCover.h"
#include "WindowTest.h"

#include <QLabel>

namespace bolster {
namespace {

TEST_F(WindowTest, ANewcomerSewsACushionWithinTwentyFiveClicks)
{
    Designer designer(window);
    sewFirstCover(designer, [](const QString&) {});
    EXPECT_LE(designer.clicks(), 25);
    int seams = 0;
    window.document().design().each<Seam>([&](ElementId, const Seam&) { ++seams; });
    EXPECT_EQ(seams, 4);
    ASSERT_TRUE(waitUntilAtRest()) << "by itself: nothing holds it";
    const Box3 box = window.solver().surface()->boundingBox();
    EXPECT_GT(box.sizes().z(), 150) << "it is filled";
    EXPECT_GT(box.sizes().x(), 380);
    EXPECT_GT(box.sizes().y(), 380);
    EXPECT_FALSE(window.findChild<QWidget*>(QStringLiteral("next-step"))->isVisible()) << "nothing is left to do";
}

TEST_F(WindowTest, ALinkInAHintPressesNothingBehindIt)
{
    Designer designer(window);
    sewFirstCover(designer, [&](const QString& at) {
        if (at != QStringLiteral("sewn"))
            return;
        auto* hint = window.findChild<QLabel*>(QStringLiteral("next-step"));
        hint->move(window.patternView().rect().center() - hint->rect().center()); // over the patches
        designer.followLink(QStringLiteral("next-step"));
        EXPECT_EQ(window.selection().elements().size(), 2U);
        const Design before = window.document().design();
        designer.point({0, 250});
        designer.point({150, 100});
        EXPECT_FALSE(window.document().gestureRunning());
        EXPECT_TRUE(window.document().design() == before) << "the pointer carries nothing along";
    });
}

} // namespace
} // namespace bolster
