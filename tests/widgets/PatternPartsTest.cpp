// The parts of the pattern view, each without the view.
#include "DrawingAids.h"
#include "PatternNavigation.h"
#include "PatternScene.h"
#include "Selection.h"
#include "TestDesigns.h"

#include <QSignalSpy>
#include <QWidget>

#include <gtest/gtest.h>

namespace bolster {
namespace {

class PatternParts : public testing::Test {
protected:
    PatternParts()
    {
        scene.reset(twoSquares());
        widget.resize(800, 600);
    }

    bool seen(const Vec2& layout) const
    {
        return QRectF(widget.rect()).contains(navigation.transform().toPixels(layout));
    }

    PatternScene scene;
    Selection selection;
    QWidget widget;
    PatternNavigation navigation{scene, selection, widget};
};

TEST_F(PatternParts, WhatWasFittedFillsTheViewUntilTheUserMovesIt)
{
    QSignalSpy byUser(&navigation, &PatternNavigation::transformChanged);
    navigation.fitAll();
    EXPECT_TRUE(seen({0, 0}));
    EXPECT_TRUE(seen({300, 100}));
    const double fitted = navigation.transform().scale();
    widget.resize(400, 300);
    navigation.resize({800, 600});
    EXPECT_LT(navigation.transform().scale(), 0.7 * fitted);
    EXPECT_TRUE(seen({300, 100}));
    EXPECT_EQ(byUser.count(), 0);

    navigation.setTransform(navigation.transform().panned({10, 0}));
    EXPECT_EQ(byUser.count(), 1);
    const double moved = navigation.transform().scale();
    widget.resize(800, 600);
    navigation.resize({400, 300});
    EXPECT_EQ(navigation.transform().scale(), moved);
}

TEST_F(PatternParts, AStripBelowCanBeLeftFree)
{
    navigation.fitAll();
    navigation.fitAbove(400);
    EXPECT_LT(navigation.transform().toPixels({0, 0}).y(), 200);
}

TEST_F(PatternParts, APlaceIsRevealedOnlyWhereItIsNotSeen)
{
    selection.set({firstSquare});
    navigation.fitSelection();
    const QPointF before = navigation.transform().toPixels({0, 0});
    navigation.reveal({50, 50});
    EXPECT_EQ(navigation.transform().toPixels({0, 0}), before);
    navigation.reveal({5000, 50});
    EXPECT_TRUE(seen({5000, 50}));
}

TEST(DrawingAids, HiddenGuidesDoNotSnap)
{
    DrawingAids aids;
    QSignalSpy changes(&aids, &DrawingAids::changed);
    aids.setGuides({{10}, {}});
    EXPECT_EQ(aids.snapSettings().guides, aids.guides());
    aids.setGuidesShown(false);
    EXPECT_EQ(aids.snapSettings().guides, PatternGuides());
    EXPECT_EQ(aids.guides().x.size(), 1U);
    EXPECT_EQ(changes.count(), 2);
}

} // namespace
} // namespace bolster
