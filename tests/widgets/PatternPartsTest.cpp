// The parts of the pattern view, each without the view.
#include "CutPattern.h"
#include "DrawingAids.h"
#include "PatternCut.h"
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

TEST_F(PatternParts, LabelsOfPiecesAreShownWhereTheirLettersCanBeRead)
{
    CutPattern cut;
    CutPiece piece;
    piece.patch = secondSquare;
    piece.label.lines = {"Second", "Cut 1"};
    piece.label.height = 6;
    cut.pieces.push_back(piece);
    const auto at = [](double pixelsPerMm) {
        return PatternTransform::fitting(Box2(Vec2(0, 0), Vec2(100, 100)), QSizeF(100, 100) * pixelsPerMm, 0);
    };
    EXPECT_FALSE(readableLabel(&cut, secondSquare, at(1))) << "letters of 4 pixels; the patch's name stands there";
    EXPECT_TRUE(readableLabel(&cut, secondSquare, at(3)));
    EXPECT_FALSE(readableLabel(&cut, firstSquare, at(3))) << "it has no piece";
    cut.pieces.front().label.height = 2; // there was little room
    EXPECT_FALSE(readableLabel(&cut, secondSquare, at(3)));
    EXPECT_FALSE(readableLabel(nullptr, secondSquare, at(3)));
}

TEST_F(PatternParts, NamesStandWhereTheLabelIsThatCannotBeRead)
{
    ASSERT_TRUE(scene.patch(secondSquare));
    PatternPatch patch = *scene.patch(secondSquare);
    CutPiece piece;
    piece.patch = secondSquare;
    piece.label.lines = {"Second", "Cut 1"};
    piece.label.height = 6;
    piece.label.width = 30;
    piece.label.at = patch.patch().outline.boundingBox().min() + Vec2(30, 20);
    const auto view = [&](double scale) {
        return PatternTransform::fitting(patch.box, QSizeF(patch.box.sizes().x(), patch.box.sizes().y()) * scale,
                                         0);
    };
    const auto lettering = [&] { return labelFrame(piece, patch, view(1.2), QFont()).boundingRect(); };
    EXPECT_EQ(lettering(), PatternLabel(patch, view(1.2), QFont()).box()) << "where it finds room";
    Patch placed = patch.patch();
    placed.cutting.label = PieceLabelPlace{piece.label.at, 0};
    patch.element = makeElement(placed);
    for (const double scale : {1.2, 4.0}) {
        const auto transform = view(scale);
        const QPolygonF frame = labelFrame(piece, patch, transform, QFont());
        ASSERT_FALSE(frame.isEmpty()) << scale;
        const QPointF at = transform.toPixels(toLayout(patch.patch(), piece.label.at));
        EXPECT_LT(QLineF(frame.boundingRect().center(), at).length(), 1e-6) << scale;
        EXPECT_GT(frame.boundingRect().height(), 8) << scale << ": large enough to be dragged";
    }
}

} // namespace
} // namespace bolster
