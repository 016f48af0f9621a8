// A designer sews a box and looks after its seams, in the real window.
#include "WindowTest.h"

#include "ElementEdits.h"
#include "SeamStretches.h"
#include "SeamsView.h"

#include <QTreeView>

#include <algorithm>

namespace bolster {
namespace {

class SewingTest : public WindowTest {
protected:
    std::vector<std::pair<ElementId, Seam>> seams()
    {
        std::vector<std::pair<ElementId, Seam>> all;
        window.document().design().each<Seam>([&](ElementId id, const Seam& seam) { all.emplace_back(id, seam); });
        return all;
    }

    QPoint middleOf(const Stretch& stretch)
    {
        const Patch& patch = *window.document().design().find<Patch>(stretch.patch);
        return patternPixel(toLayout(patch, patch.outline.at(0.5 * (stretch.from + stretch.to))));
    }

    void click(QPoint at)
    {
        move(window.patternView(), at, Qt::NoButton);
        press(window.patternView(), at);
        release(window.patternView(), at);
    }
};

TEST_F(SewingTest, SewsABox)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    auto expected = seams();
    ASSERT_EQ(expected.size(), 8U);
    std::vector<ElementId> ids;
    for (const auto& [id, seam] : expected)
        ids.push_back(id);
    window.document().commit(edits::removeElements(window.document().design(), ids));
    ASSERT_TRUE(seams().empty());

    QTest::keyClick(&window.patternView(), Qt::Key_W);
    ASSERT_EQ(window.patternView().tool(), PatternToolKind::Sew);
    EXPECT_TRUE(window.command("tool.sew")->isChecked());
    for (const auto& [id, seam] : expected) {
        click(middleOf(seam.a));
        click(middleOf(seam.b));
    }
    const auto sewn = seams();
    ASSERT_EQ(sewn.size(), expected.size());
    for (std::size_t i = 0; i < sewn.size(); ++i) {
        Seam plain = expected[i].second;
        plain.trim = {};
        EXPECT_EQ(sewn[i].second, plain) << i;
    }
    EXPECT_TRUE(waitUntilSolved());
    window.document().jumpTo(0);
    EXPECT_EQ(seams(), expected);
}

TEST_F(SewingTest, TheMenuChangesTheSelectedSeams)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const auto before = seams();
    EXPECT_FALSE(window.command("seam.flip")->isEnabled());
    window.command("seam.list")->trigger();
    EXPECT_TRUE(window.seams().isVisible());
    window.seams().table().selectAll();
    EXPECT_EQ(window.selection().elements().size(), before.size());
    EXPECT_TRUE(window.command("seam.continuity-c0")->isChecked());

    window.command("seam.continuity-g1")->trigger();
    for (const auto& [id, seam] : seams())
        EXPECT_EQ(seam.continuity, Continuity::G1);
    EXPECT_TRUE(window.command("seam.continuity-g1")->isChecked());
    EXPECT_FALSE(window.command("seam.continuity-c0")->isChecked());
    window.command("edit.undo")->trigger();
    window.selection().set({before.front().first});
    window.command("seam.flip")->trigger();
    EXPECT_EQ(seams().front().second.reversed, !before.front().second.reversed);
    window.command("edit.undo")->trigger();
    EXPECT_EQ(seams(), before);
}

} // namespace
} // namespace bolster
