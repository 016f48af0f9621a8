// Mirror twins in the pattern view and the inspector, by real events.
#include "Document.h"
#include "Inspector.h"
#include "PatternView.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "SeamEdits.h"
#include "Selection.h"
#include "TestDesigns.h"
#include "TwinEdits.h"
#include "Twins.h"
#include "ViewColors.h"

#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

#include <array>

namespace bolster {
namespace {

class TwinViewTest : public testing::Test {
protected:
    TwinViewTest()
    {
        const Design squares = twoSquares();
        document.reset(squares.with(
            edits::makeTwins(squares, std::array{firstSquare}, [](const std::string& name) { return name; })));
        twin = twinOf(document.design(), firstSquare);
        view.resize(900, 700);
        view.show();
        view.navigation().fitAll();
        selection.set({firstSquare});
    }

    QPoint pixel(const Vec2& layout) const { return view.navigation().transform().toPixels(layout).toPoint(); }
    void move(QPoint to, Qt::MouseButtons buttons = {})
    {
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, buttons, {});
        QApplication::sendEvent(&view, &event);
    }

    void drag(QPoint from, QPoint to)
    {
        move(from);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        move((from + to) / 2, Qt::LeftButton);
        move(to, Qt::LeftButton);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
    }

    Vec2 point(ElementId patch, std::size_t i) const
    {
        return document.design().find<Patch>(patch)->outline.points()[i];
    }
    /// Of a square of 9 pixels.
    bool shows(const QColor& color, const Vec2& layout)
    {
        const QImage picture = view.grab().toImage();
        const QPoint at = pixel(layout);
        for (int x = -4; x <= 4; ++x)
            for (int y = -4; y <= 4; ++y)
                if (picture.pixelColor(at + QPoint(x, y)) == color)
                    return true;
        return false;
    }

    QPushButton* button(Inspector& inspector, const QString& text)
    {
        for (auto* button : inspector.findChildren<QPushButton*>())
            if (button->text().remove(u'&') == text)
                return button;
        return nullptr;
    }

    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
    ElementId twin{};
};

TEST_F(TwinViewTest, ADragOfAPointMovesBothInOneEdit)
{
    const Design before = document.design();
    drag(pixel({100, 100}), pixel({130, 80}));
    const Vec2 moved = point(firstSquare, 2);
    EXPECT_GT((moved - Vec2(100, 100)).norm(), 20);
    EXPECT_EQ(point(twin, 2), Vec2(-moved.x(), moved.y()));
    EXPECT_EQ(document.history().count(), 2);

    selection.set({twin});
    drag(pixel({-moved.x(), moved.y()}), pixel({-100, 140}));
    EXPECT_EQ(point(firstSquare, 2), Vec2(-point(twin, 2).x(), point(twin, 2).y()));
    EXPECT_NE(point(firstSquare, 2), moved);
    document.undo();
    document.undo();
    EXPECT_TRUE(document.design() == before);
}

TEST_F(TwinViewTest, ADragOfAReleasedPointMovesOne)
{
    document.commit(edits::releasePoints(document.design(), firstSquare, std::array{2}));
    drag(pixel({100, 100}), pixel({130, 80}));
    EXPECT_NE(point(firstSquare, 2), Vec2(100, 100));
    EXPECT_EQ(point(twin, 2), Vec2(-100, 100));
    drag(pixel({0, 100}), pixel({10, 120}));
    keepPicture(view, QStringLiteral("twins"));
}

TEST_F(TwinViewTest, ShowsTheAxisAndThePointThatMovesAlong)
{
    const ViewColors colors = ViewColors::of(view.palette());
    EXPECT_FALSE(shows(colors.accent, {-100, 100}));
    move(pixel({100, 100}));
    EXPECT_TRUE(shows(colors.accent, {-100, 100})) << "a ring around the other point";
    move(pixel({50, 50}));
    EXPECT_FALSE(shows(colors.accent, {-100, 100}));

    const QImage with = view.grab().toImage();
    Settings settings = document.design().settings();
    settings.symmetry.reset();
    document.commit({{}, {{settingsId, nullptr, makeElement(settings)}}});
    const QImage without = view.grab().toImage();
    int different = 0;
    for (int y = 0; y < with.height(); ++y)
        different += with.pixelColor(pixel({0, 0}).x(), y) != without.pixelColor(pixel({0, 0}).x(), y);
    EXPECT_GT(different, view.height() / 4);
}

TEST_F(TwinViewTest, TheInspectorUnlinksAndLinksAgain)
{
    document.commit(edits::releasePoints(document.design(), firstSquare, std::array{2}));
    drag(pixel({100, 100}), pixel({130, 80}));
    Inspector inspector(document, selection, problems);
    inspector.show();
    QPushButton* relink = button(inspector, QStringLiteral("Re-link all points"));
    ASSERT_TRUE(relink);
    relink->click();
    EXPECT_EQ(point(firstSquare, 2), Vec2(100, 100));
    EXPECT_TRUE(releasedPoints(document.design(), twin).empty());
    QPushButton* unlink = button(inspector, QStringLiteral("Unlink from its twin"));
    ASSERT_TRUE(unlink);
    unlink->click();
    EXPECT_EQ(twinOf(document.design(), firstSquare), noElement);
    selection.set({secondSquare});
    EXPECT_FALSE(button(inspector, QStringLiteral("Unlink from its twin")));
}

TEST_F(TwinViewTest, TheInspectorReleasesAndRelinksASeam)
{
    document.commit(edits::addSeam(document.design(), {firstSquare, 0, 1}, {twin, 2, 3}, true));
    ElementId seam{};
    document.design().each<Seam>([&](ElementId id, const Seam&) { seam = id; });
    ASSERT_NE(edits::mirroredElement(document.design(), seam), noElement);
    Inspector inspector(document, selection, problems);
    inspector.show();
    selection.set({seam});
    QPushButton* release = button(inspector, QStringLiteral("Release from its mirror image"));
    ASSERT_TRUE(release);
    release->click();
    EXPECT_TRUE(edits::sewingReleased(document.design(), seam));
    document.commit(edits::setContinuity(document.design(), std::array{seam}, Continuity::G1));
    QPushButton* relink = button(inspector, QStringLiteral("Re-link to its mirror image"));
    ASSERT_TRUE(relink);
    relink->click();
    EXPECT_EQ(document.design().find<Seam>(seam)->continuity, Continuity::C0);
    EXPECT_FALSE(edits::sewingReleased(document.design(), seam));
}

TEST_F(TwinViewTest, MarksTheMirrorImageOfTheSelection)
{
    selection.clear();
    const QImage before = view.grab().toImage();
    selection.set({firstSquare});
    EXPECT_NE(view.grab().toImage().pixel(pixel({-70, 30})), before.pixel(pixel({-70, 30})));
    PatternLayers layers = view.shown().layers();
    layers.twins = false;
    view.shown().setLayers(layers);
    EXPECT_EQ(view.grab().toImage().pixel(pixel({-70, 30})), before.pixel(pixel({-70, 30})));
    selection.clear();
    Inspector inspector(document, selection, problems);
    for (const QLabel* label : inspector.findChildren<QLabel*>())
        EXPECT_FALSE(label->text().endsWith(u',')) << label->text().toStdString();
}

} // namespace
} // namespace bolster
