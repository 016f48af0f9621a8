// The parts of the 3D view, each without the view.
#include "CameraDrag.h"
#include "CoverNavigation.h"
#include "CoverSetup.h"
#include "Document.h"
#include "PointShades.h"
#include "SceneVisibility.h"
#include "Selection.h"
#include "ShownScene.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace bolster {
namespace {

using Layer = SceneVisibility::Layer;

class CoverParts : public testing::Test {
protected:
    CoverParts()
    {
        document.reset(test::twoSquares());
        widget.resize(800, 600);
        navigation.resize();
        shown.setSurface(test::twoSquaresCover());
    }

    bool lineBeyond(double x) const
    {
        for (const SceneLine& line : shown.scene().lines)
            for (const Eigen::Vector3f& p : line.points)
                if (p.x() > x + 0.01)
                    return true;
        return false;
    }

    static QMouseEvent pointer(QEvent::Type type, QPointF at, Qt::MouseButton button)
    {
        return {type, at, at, button, button, {}};
    }

    Document document;
    Selection selection;
    SceneVisibility visibility;
    ShownScene shown{document, selection, visibility};
    QWidget widget; ///< never shown: nothing flies
    CoverNavigation navigation{shown, widget};
};

TEST_F(CoverParts, TheSceneFollowsWhatIsToBeSeen)
{
    QSignalSpy changes(&shown, &ShownScene::changed);
    EXPECT_FALSE(shown.empty());
    EXPECT_NEAR(shown.scene().box.max().z(), 50, 1e-6) << "the curve";
    visibility.setLayerVisible(Layer::FixationCurves, false);
    EXPECT_NEAR(shown.scene().box.max().z(), 0, 1e-6);
    visibility.setLayerVisible(Layer::Cover, false);
    EXPECT_FALSE(shown.scene().surface);
    EXPECT_TRUE(shown.empty());
    EXPECT_FALSE(shown.scene().box.isEmpty()) << "ground to draw on";
    EXPECT_EQ(changes.count(), 2);
    EXPECT_TRUE(visibility.unseen(document.design()).contains(test::curveId));
}

TEST_F(CoverParts, TheSectionCutsWhatIsShownButNotWhatLiesOverIt)
{
    EXPECT_TRUE(lineBeyond(150));
    shown.setSection(SectionPlane{Vec3::UnitX(), 150});
    EXPECT_FALSE(lineBeyond(150));
    shown.setOverlay([] { return std::vector<SceneLine>{{{{300, 0, 0}, {300, 100, 0}}, Qt::red}}; });
    shown.updateMarks();
    EXPECT_TRUE(lineBeyond(150));
}

TEST(PointShadesTest, AWallIsEvenAndOtherwiseThanTheFloorAtIt)
{
    std::vector<Vec3> points;
    for (int i = 0; i < 100; ++i)
        for (int k = 0; k < 100; ++k)
            points.emplace_back(10 * i, 10 * k, 0.01 * ((i * k) % 7)); // the floor, then a wall at its edge
    const std::size_t floor = points.size();
    for (int i = 0; i < 100; ++i)
        for (int k = 1; k < 100; ++k)
            points.emplace_back(10 * i, 990, 10 * k);
    points.emplace_back(500, 100, 700); // in the air
    const std::vector<float> shades = pointShades(points);
    ASSERT_EQ(shades.size(), points.size());
    const float ofFloor = shades[50 * 100 + 20], ofWall = shades[floor + 50 * 99 + 60];
    EXPECT_GT(std::abs(ofFloor - ofWall), 0.05F);
    for (int i = 10; i < 90; ++i) {
        EXPECT_NEAR(shades[static_cast<std::size_t>(i) * 100 + 30], ofFloor, 0.02F);
        EXPECT_NEAR(shades[floor + static_cast<std::size_t>(i) * 99 + 60], ofWall, 0.02F);
    }
    EXPECT_TRUE(pointShades({}).empty());
    EXPECT_EQ(pointShades({Vec3(1, 2, 3), Vec3(1, 2, 3)}).size(), 2u) << "all in one place";
}

TEST_F(CoverParts, NavigationFitsWhatIsSelected)
{
    navigation.setStandardView(Camera::StandardView::Top);
    EXPECT_TRUE(navigation.camera().backward().isApprox(Vec3(0, 0, 1), 1e-6));
    EXPECT_TRUE(navigation.inPicture(shown.scene().box));
    const double whole = navigation.camera().distance;
    selection.set({test::leftPatch});
    EXPECT_NEAR(shown.selectedBox().max().x(), 200, 1e-6);
    QSignalSpy moves(&navigation, &CoverNavigation::moved);
    navigation.fitSelection();
    EXPECT_LT(navigation.camera().distance, 0.8 * whole);
    EXPECT_EQ(moves.count(), 1);
    navigation.reveal({9000, 0, 0});
    EXPECT_NEAR(navigation.camera().target.x(), 9000, 1e-6);
}

TEST_F(CoverParts, AViewThatWasGivenStaysUntilAnotherIsAskedFor)
{
    Camera kept = navigation.camera();
    kept.azimuth = 0.3;
    navigation.returnTo(kept);
    EXPECT_TRUE(navigation.hasReturned());
    shown.setSurface(nullptr);
    shown.setSurface(test::twoSquaresCover());
    EXPECT_EQ(navigation.camera().azimuth, 0.3);
    navigation.setStandardView(Camera::StandardView::Front);
    EXPECT_FALSE(navigation.hasReturned());
}

TEST_F(CoverParts, WhoDragsTheCameraAndComesBackHasNotClicked)
{
    navigation.setStandardView(Camera::StandardView::Front);
    const double before = navigation.camera().azimuth;
    CameraDrag drag(navigation, shown);
    drag.start(pointer(QEvent::MouseButtonPress, {400, 300}, Qt::RightButton), Qt::RightButton, ViewMove::Turn);
    EXPECT_TRUE(drag.running());
    drag.move(pointer(QEvent::MouseMove, {440, 300}, Qt::NoButton));
    EXPECT_NE(navigation.camera().azimuth, before);
    drag.move(pointer(QEvent::MouseMove, {400, 300}, Qt::NoButton));
    EXPECT_NEAR(navigation.camera().azimuth, before, 1e-9);
    EXPECT_FALSE(drag.release(pointer(QEvent::MouseButtonRelease, {400, 300}, Qt::LeftButton)));
    EXPECT_TRUE(drag.release(pointer(QEvent::MouseButtonRelease, {400, 300}, Qt::RightButton)));
    EXPECT_FALSE(drag.clicked());
    drag.start(pointer(QEvent::MouseButtonPress, {400, 300}, Qt::RightButton), Qt::RightButton, ViewMove::Turn);
    EXPECT_TRUE(drag.release(pointer(QEvent::MouseButtonRelease, {401, 300}, Qt::RightButton)));
    EXPECT_TRUE(drag.clicked());
}

} // namespace
} // namespace bolster
