// What of the scene is shown, and the same point in both views.
#include "CoverPlaces.h"
#include "Crosshair.h"
#include "Document.h"
#include "Hiding.h"
#include "PatternView.h"
#include "ProblemSet.h"
#include "SectionPanel.h"
#include "Selection.h"
#include "SurfaceSetup.h"
#include "SurfaceView.h"
#include "VisibleCover.h"

#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include <gtest/gtest.h>

namespace bolster::test {
namespace {

class SurfaceShown : public testing::Test {
protected:
    SurfaceShown()
    {
        document.reset(twoSquares());
        view.setSoftwareRenderer(std::make_unique<StubRenderer>(log));
        view.resize(800, 600);
        view.show();
        view.setSurface(twoSquaresCover());
        Camera camera = view.camera();
        camera.azimuth = 0;
        camera.elevation = 1.2;
        camera.fit(Box3(Vec3(0, 0, 0), Vec3(400, 200, 50)));
        view.setCamera(camera);
    }

    QPointF pixel(const Vec3& point) const
    {
        const Vec2 at = *view.camera().pixel(point);
        return {at.x(), at.y()};
    }
    SurfaceHit::Kind kindAt(const Vec3& point) const { return view.hit(pixel(point)).kind; }

    std::shared_ptr<StubRenderer::Log> log = std::make_shared<StubRenderer::Log>();
    Document document;
    Selection selection;
    SurfaceView view{document, selection};
    Mouse mouse{view};
};

TEST_F(SurfaceShown, HiddenPatchesAreNeitherDrawnNorHit)
{
    QSignalSpy changes(&view, &SurfaceView::hiddenChanged);
    view.setHidden({rightPatch});
    EXPECT_EQ(kindAt({320, 50, 0}), SurfaceHit::Kind::Nothing);
    EXPECT_EQ(kindAt({80, 50, 0}), SurfaceHit::Kind::Cover);
    EXPECT_EQ(kindAt({300, 100, 50}), SurfaceHit::Kind::Curve) << "curves stay";
    EXPECT_TRUE(QTest::qWaitFor([&] {
        return log->count() > 0 && log->last().surface && log->last().surface->topology->patches.size() == 1;
    }));
    EXPECT_EQ(view.surface()->topology->patches.size(), 2u) << "the surface itself is whole";
    view.setHidden({curveId});
    EXPECT_EQ(kindAt({300, 100, 50}), SurfaceHit::Kind::Cover);
    view.setHidden({});
    EXPECT_EQ(kindAt({320, 50, 0}), SurfaceHit::Kind::Cover);
    EXPECT_EQ(changes.count(), 3);
}

TEST_F(SurfaceShown, TheVisibleCoverKeepsItsVertices)
{
    const SurfaceMeshPtr whole = twoSquaresCover();
    VisibleCover visible;
    EXPECT_EQ(visible.of(whole, {}), whole);
    EXPECT_EQ(visible.of(whole, {curveId}), whole);
    const SurfaceMeshPtr rest = visible.of(whole, {leftPatch});
    ASSERT_EQ(rest->topology->patches.size(), 1u);
    EXPECT_EQ(rest->topology->patches[0].firstTriangle, 0u);
    EXPECT_EQ(rest->topology->triangles.size(), rest->topology->patches[0].triangleCount);
    EXPECT_EQ(rest->positions, whole->positions);
    EXPECT_TRUE(rest->topology->seams.empty()) << "its other side is hidden";
    EXPECT_EQ(visible.of(whole, {leftPatch})->topology, rest->topology) << "made once";
}

TEST_F(SurfaceShown, IsolatingKeepsWhatBelongsToThePatch)
{
    const Design design = document.design();
    HandleCurve handle{{"Handle", leftPatch, BSpline2(1, false, {{20, 20}, {90, 90}})},
                       BSpline3(1, false, {{20, 20, 0}, {90, 90, 0}})};
    FixationSeam seam;
    seam.stretch = {leftPatch, 2, 3};
    seam.curve = curveId;
    const Design more = design.with({{},
                                     {{ElementId{60}, nullptr, makeElement(handle)},
                                      {ElementId{61}, nullptr, makeElement(seam)},
                                      {ElementId{62}, nullptr, makeElement(Frame{})}}});
    EXPECT_EQ(allBut(more, {leftPatch}), (std::set<ElementId>{rightPatch, ElementId{62}}));
    EXPECT_EQ(allBut(more, {rightPatch}), (std::set<ElementId>{leftPatch, curveId, ElementId{60}, ElementId{62}}));
    EXPECT_EQ(hideable(more, {leftPatch, seamId, fabricId}), std::set<ElementId>{leftPatch});
    EXPECT_TRUE(isHidden(more, {leftPatch}, ElementId{60}));
}

TEST_F(SurfaceShown, TheSectionCutsPicturesLinesAndHits)
{
    view.setSection(SectionPlane{Vec3::UnitX(), 150});
    EXPECT_EQ(kindAt({320, 50, 0}), SurfaceHit::Kind::Nothing);
    EXPECT_EQ(kindAt({80, 50, 0}), SurfaceHit::Kind::Cover);
    EXPECT_TRUE(QTest::qWaitFor([&] { return log->count() > 0 && log->last().section == view.section(); }));
    view.setSection(SectionPlane{-Vec3::UnitX(), -150});
    EXPECT_EQ(kindAt({320, 50, 0}), SurfaceHit::Kind::Cover);
    EXPECT_EQ(kindAt({80, 50, 0}), SurfaceHit::Kind::Nothing);
    view.setSection(std::nullopt);
    EXPECT_EQ(kindAt({80, 50, 0}), SurfaceHit::Kind::Cover);
}

TEST(SectionPlaneTest, LinesAreCutWhereTheyCrossThePlane)
{
    const SectionPlane section{Vec3::UnitX(), 10};
    const std::vector<Eigen::Vector3f> line = {{0, 0, 0}, {20, 0, 0}, {20, 5, 0}, {0, 5, 0}, {5, 5, 0}};
    const auto parts = keptParts(line, section);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0], (std::vector<Eigen::Vector3f>{{0, 0, 0}, {10, 0, 0}}));
    EXPECT_EQ(parts[1], (std::vector<Eigen::Vector3f>{{10, 5, 0}, {0, 5, 0}, {5, 5, 0}}));
    EXPECT_EQ(keptPoints(line, section).size(), 3u);
    EXPECT_EQ(sectionRange(Box3(Vec3(1, 2, 3), Vec3(5, 6, 7)), -Vec3::UnitY()), std::pair(-6.0, -2.0));
}

TEST_F(SurfaceShown, ThePanelMovesTheSection)
{
    view.setSectionShown(true);
    ASSERT_TRUE(view.section());
    EXPECT_NEAR(view.section()->normal.x(), 1, 1e-12);
    EXPECT_NEAR(view.section()->offset, 200, 1);
    auto* slider = view.findChild<SectionPanel*>()->findChild<QSlider*>();
    slider->setValue(slider->maximum() / 4);
    EXPECT_NEAR(view.section()->offset, 100, 1);
    view.setSectionShown(false);
    EXPECT_FALSE(view.section());
}

TEST_F(SurfaceShown, HandlesAndFancySeamsHaveLayers)
{
    const HandleCurve handle{{"Handle", leftPatch, BSpline2(1, false, {{20, 20}, {90, 20}})},
                             BSpline3(1, false, {{20, 20, 0}, {90, 20, 0}})};
    document.reset(document.design().with({{}, {{ElementId{60}, nullptr, makeElement(handle)}}}));
    EXPECT_EQ(kindAt({50, 20, 0}), SurfaceHit::Kind::Curve);
    view.setLayerVisible(SurfaceView::Layer::FixationCurves, false);
    EXPECT_EQ(kindAt({50, 20, 0}), SurfaceHit::Kind::Curve);
    view.setLayerVisible(SurfaceView::Layer::HandleCurves, false);
    EXPECT_EQ(kindAt({50, 20, 0}), SurfaceHit::Kind::Cover);
}

TEST_F(SurfaceShown, OpacityOfFramesReachesThePicture)
{
    view.setFrameOpacity(0.9);
    EXPECT_TRUE(QTest::qWaitFor([&] { return log->count() > 0 && log->last().frameOpacity == 2; }));
}

TEST_F(SurfaceShown, ThePointUnderThePointerIsKnownInBothViews)
{
    ProblemSet problems;
    PatternView pattern(document, selection, problems);
    pattern.resize(600, 500);
    pattern.show();
    pattern.fitAll();
    QObject::connect(&view, &SurfaceView::coverPointed, &pattern, &PatternView::showPlace);
    QObject::connect(&pattern, &PatternView::patchPointed, &view, &SurfaceView::showPlace);
    auto* onPattern = pattern.findChild<Crosshair*>();
    auto* onCover = view.findChild<Crosshair*>();

    mouse.move(pixel({250, 60, 0}));
    EXPECT_TRUE(onPattern->isVisible());
    const QPointF there = pattern.transform().toPixels({50, 60});
    EXPECT_LT((QPointF(onPattern->geometry().center()) - there).manhattanLength(), 3);
    mouse.move({2, 2});
    EXPECT_FALSE(onPattern->isVisible());

    Mouse(pattern).move(pattern.transform().toPixels({30, 160}));
    EXPECT_TRUE(onCover->isVisible());
    // Both patches lie at the same place of the layout: the upper one is under the pointer.
    EXPECT_LT((QPointF(onCover->geometry().center()) - pixel({230, 160, 0})).manhattanLength(), 4);
}

TEST_F(SurfaceShown, AClickIsToldOnce)
{
    QSignalSpy clicks(&view, &SurfaceView::coverClicked);
    mouse.click(pixel({250, 60, 0}));
    ASSERT_EQ(clicks.count(), 1);
    const auto point = clicks[0][0].value<CoverPoint>();
    EXPECT_EQ(point.patch, rightPatch);
    EXPECT_LT((point.outline - Vec2(50, 60)).norm(), 2);
    mouse.drag(pixel({250, 60, 0}), pixel({150, 60, 0}));
    EXPECT_EQ(clicks.count(), 1) << "a drag turns the view";
}

} // namespace
} // namespace bolster::test
