// Stitching and piping seams and edges in the pattern view.
#include "Document.h"
#include "PatternTrims.h"
#include "PatternView.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "TestDesigns.h"
#include "TrimEdits.h"

#include <QTest>

#include <gtest/gtest.h>

#include <array>

namespace bolster {
namespace {

class TrimToolTest : public testing::Test {
protected:
    TrimToolTest()
    {
        document.reset(twoSquares());
        view.resize(900, 500);
        view.show();
        view.navigation().fitAll();
        view.setTool(PatternToolKind::Trim);
    }

    void click(const Vec2& layout)
    {
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.navigation().transform().toPixels(layout).toPoint());
    }

    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
};

TEST_F(TrimToolTest, AnEdgeGetsATrimOfItsOwn)
{
    click({50, 100});
    document.design().each<OutlineTrim>([&](ElementId id, const OutlineTrim& border) {
        EXPECT_TRUE(selection.contains(id));
        EXPECT_EQ(border.stretch, (Stretch{firstSquare, 2, 3}));
        EXPECT_EQ(border.trim.stitch, SeamTrim::Stitch::Single);
    });
    EXPECT_EQ(document.history().count(), 2);
    click({50, 100}); // once more: it has one
    EXPECT_EQ(document.history().count(), 2);
}

TEST_F(TrimToolTest, ASeamAndAFixedStretchKeepTheirs)
{
    click({100, 50});
    EXPECT_TRUE(document.design().find<Seam>(squareSeam)->trim.hasTrimmings());
    EXPECT_TRUE(selection.contains(squareSeam));
    click({300, 50});
    EXPECT_TRUE(document.design().find<FixationSeam>(squareFixation)->trim.hasTrimmings());
    document.undo();
    EXPECT_FALSE(document.design().find<FixationSeam>(squareFixation)->trim.hasTrimmings());
}

TEST(PatternTrims, MarksLieWhereStitchesAndPipingDo)
{
    SeamTrim trim;
    trim.stitch = SeamTrim::Stitch::Twin;
    trim.stitchDistance = 6;
    trim.pipingRadius = 3;
    const Design design = twoSquares().with(edits::setTrim(twoSquares(), std::array{squareSeam}, trim));
    PatternTrims trims;
    trims.update(design, {squareSeam}, {});
    std::map<ElementId, double> stitched, piped; // place across the seam
    for (const auto& [owner, mark] : trims.marks()) {
        const QRectF box = mark.path.boundingRect();
        EXPECT_NEAR(box.width(), 0, 1e-9);
        EXPECT_NEAR(box.height(), 100, 1e-6);
        (mark.stitch > 0 ? stitched : piped)[mark.patch] = box.center().x();
        EXPECT_EQ(mark.width, mark.stitch > 0 ? trim.threadWidth : 6);
    }
    EXPECT_NEAR(stitched[firstSquare], 94, 1e-6);
    EXPECT_NEAR(stitched[secondSquare], 206, 1e-6);
    EXPECT_NEAR(piped[firstSquare], 100, 1e-6);
    EXPECT_NEAR(piped[secondSquare], 200, 1e-6);
    trims.update(twoSquares(), {squareSeam}, {});
    EXPECT_TRUE(trims.marks().empty());
}

} // namespace
} // namespace bolster
