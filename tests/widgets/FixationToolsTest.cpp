#include "CoverPath.h"
#include "CoverSetup.h"
#include "CoverView.h"
#include "Document.h"
#include "PatternView.h"
#include "ProblemSet.h"
#include "SegmentDistance.h"
#include "Selection.h"
#include "StretchToFix.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster::test {
namespace {

constexpr ElementId frameId{30};
constexpr double radius = 150;
const Vec3 middle(200, 100, 0); ///< of the frame: half a tube along y

double fromAxis(const Vec3& p)
{
    return std::hypot(p.x() - middle.x(), p.z() - middle.z());
}

Vec3 onTube(double degrees, double y)
{
    const double angle = degrees * std::numbers::pi / 180;
    return {middle.x() + radius * std::sin(angle), y, middle.z() + radius * std::cos(angle)};
}

std::shared_ptr<const TriangleMesh> tube()
{
    auto mesh = std::make_shared<TriangleMesh>();
    constexpr std::uint32_t sides = 180;
    for (std::uint32_t i = 0; i <= sides; ++i)
        for (const double y : {0.0, 200.0})
            mesh->points.push_back(onTube(-90 + 180.0 * i / sides, y));
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 2 * i;
        mesh->triangles.push_back({a, a + 2, a + 1});
        mesh->triangles.push_back({a + 1, a + 2, a + 3});
    }
    return mesh;
}

std::vector<FixationCurve> curvesOf(const Document& document)
{
    std::vector<FixationCurve> curves;
    document.design().each<FixationCurve>([&](ElementId, const FixationCurve& c) { curves.push_back(c); });
    return curves;
}

class FixationDrawing : public testing::Test {
protected:
    FixationDrawing()
    {
        Frame frame;
        frame.name = "Tube";
        frame.file = "tube.obj";
        document.reset(twoSquares().with({{}, {{frameId, nullptr, makeElement(frame)}}}));
        view.setSoftwareRenderer(std::make_unique<StubRenderer>(log));
        view.resize(800, 600);
        view.show();
        lookFromAbove();
    }

    void showFrame()
    {
        DesignFiles files;
        files.meshes[frameId] = tube();
        view.shown().setFiles(files);
        lookFromAbove();
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.hit(pixel(onTube(10, 40))).kind == CoverHit::Kind::Frame; }));
    }

    void lookFromAbove()
    {
        Camera camera = view.navigation().camera();
        camera.azimuth = 0;
        camera.elevation = 1.2;
        camera.fit(Box3(Vec3(0, 0, 0), Vec3(400, 200, 150)));
        view.navigation().setCamera(camera);
    }

    QPointF pixel(const Vec3& point) const
    {
        const Vec2 at = *view.navigation().camera().pixel(point);
        return {at.x(), at.y()};
    }
    /// A curve with one point on the tube, ready to be dragged.
    void selectPointAt(const Vec3& at)
    {
        FixationCurve curve{"Bent", BSpline3(1, false, {at, at + Vec3(0, 80, 90)})};
        document.reset(document.design().with({{}, {{bent, nullptr, makeElement(curve)}}}));
        selection.set({bent}, {{bent, 0}});
    }
    Vec3 bentPoint() const { return document.design().find<FixationCurve>(bent)->curve.points().front(); }

    const ElementId bent{40};
    std::shared_ptr<StubRenderer::Log> log = std::make_shared<StubRenderer::Log>();
    Document document;
    Selection selection;
    CoverView view{document, selection};
    Mouse mouse{view};
};

TEST_F(FixationDrawing, FollowsTheFrameBetweenClicks)
{
    showFrame();
    view.setTool(CoverToolKind::DrawFixation);
    QSignalSpy ended(&view, &CoverView::toolChanged);
    for (const double angle : {-50.0, 0.0, 45.0})
        mouse.click(pixel(onTube(angle, 60)));
    QTest::keyClick(&view, Qt::Key_Return);
    const std::vector<FixationCurve> curves = curvesOf(document);
    ASSERT_EQ(curves.size(), 2u);
    const BSpline3& drawn = curves.back().curve;
    EXPECT_FALSE(drawn.closed());
    EXPECT_LT((drawn.at(drawn.domainStart()) - onTube(-50, 60)).norm(), 2);
    EXPECT_LT((drawn.at(drawn.domainEnd()) - onTube(45, 60)).norm(), 2);
    for (int k = 0; k <= 50; ++k)
        EXPECT_NEAR(fromAxis(drawn.at(drawn.domainStart() + drawn.period() * k / 50)), radius, 0.7);
    EXPECT_LE(drawn.pointCount(), 12);
    EXPECT_EQ(selection.elements().size(), 1u);
    EXPECT_TRUE(QTest::qWaitFor([&] { return ended.count() == 1; }));
    document.undo();
    EXPECT_EQ(curvesOf(document).size(), 1u) << "one edit";
}

TEST_F(FixationDrawing, IsDrawnToWhatAWindowOffersWhenNearUnlessCtrlIsHeld)
{
    showFrame();
    GuestMarks guests;
    std::vector<Vec3> around;
    for (int degrees = -60; degrees <= 60; degrees += 2)
        around.push_back(onTube(degrees, 120));
    guests.catching = {around, {Vec3(350, 80, -80), Vec3(50, 80, -80)}};
    view.shown().setGuests(guests);
    const Vec3 offered = onTube(-31, 120);
    const auto drawTo = [&](QPointF to, Qt::KeyboardModifiers keys) {
        view.setTool(CoverToolKind::DrawFixation);
        mouse.click(pixel(onTube(-30, 60)));
        QTest::mouseClick(&view, Qt::LeftButton, keys, to.toPoint());
        QTest::keyClick(&view, Qt::Key_B);
        QTest::keyClick(&view, Qt::Key_Return);
        const Vec3 end = curvesOf(document).back().curve.points().back();
        document.undo(); // its end would catch the next one
        return end;
    };
    const QPointF beside = pixel(offered) + QPointF(0, 5);
    const double size = view.navigation().camera().pixelSize(offered);
    const auto away = [&](const Vec3& at) {
        double nearest = 1e9;
        for (std::size_t k = 1; k < around.size(); ++k)
            nearest = std::min(nearest, segmentDistance<3>(at, around[k - 1], around[k]));
        return nearest;
    };
    EXPECT_LT(away(drawTo(beside, {})), 1e-9);
    EXPECT_GT(away(drawTo(beside, Qt::ControlModifier)), 2 * size);
    EXPECT_GT(away(drawTo(pixel(offered) + QPointF(0, 20), {})), 10 * size) << "too far away";
    // Behind the tube nothing is caught.
    const QPointF over = pixel(Vec3(200, 80, -80));
    EXPECT_GT(drawTo(over, {}).z(), 0);
}

OfferedEdgesPtr rims()
{
    OfferedEdges offered;
    FrameEdge left, right;
    for (int angle = -90; angle <= 90; angle += 2) {
        left.points.push_back(onTube(angle, 0));
        right.points.push_back(onTube(angle, 200));
    }
    offered.single = {left, right};
    offered.joined = offered.single;
    offered.single[0].points.resize(60);
    return std::make_shared<const OfferedEdges>(std::move(offered));
}

TEST_F(FixationDrawing, AClickOnAnEdgeMakesACurveOfIt)
{
    showFrame();
    QSignalSpy failed(&view, &CoverView::failed);
    view.startFrameEdges(rims());
    mouse.move(pixel(onTube(20, 0)));
    mouse.click(pixel(onTube(20, 0)) + QPointF(0, 3));
    std::vector<FixationCurve> curves = curvesOf(document);
    ASSERT_EQ(curves.size(), 2u);
    const BSpline3 made = curves.back().curve;
    for (int k = 0; k <= 50; ++k) {
        const Vec3 at = made.at(made.domainStart() + made.period() * k / 50);
        EXPECT_NEAR(fromAxis(at), radius, 0.3);
        EXPECT_NEAR(at.y(), 0, 1e-6);
    }
    EXPECT_EQ(selection.elements().size(), 1u);
    mouse.click(pixel(onTube(20, 0)));
    EXPECT_EQ(curvesOf(document).size(), 2u) << "it is there already";
    mouse.click(pixel(onTube(20, 0)), Qt::ControlModifier);
    curves = curvesOf(document);
    ASSERT_EQ(curves.size(), 3u) << "the edge alone is another one";
    EXPECT_LT(curves.back().curve.at(curves.back().curve.domainEnd()).x(), onTube(60, 0).x());
    mouse.click(pixel(onTube(20, 100)));
    EXPECT_EQ(curvesOf(document).size(), 3u);
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(view.tool(), CoverToolKind::FixEdge) << "it stays for the next edge";
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.tool() == CoverToolKind::Select; }));
}

TEST_F(FixationDrawing, StraightIsStraightWhateverLiesBetween)
{
    showFrame();
    view.setTool(CoverToolKind::DrawFixation);
    QTest::keyClick(&view, Qt::Key_B);
    for (const double angle : {-50.0, 0.0, 45.0})
        mouse.click(pixel(onTube(angle, 60)));
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("straight from point to point"))) << "it says so";
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(curvesOf(document).size(), 2u);
    const BSpline3 drawn = curvesOf(document).back().curve;
    EXPECT_EQ(drawn.degree(), 1);
    ASSERT_EQ(drawn.pointCount(), 3) << "points are where the user set them, and nowhere else";
    EXPECT_LT((drawn.points()[1] - onTube(0, 60)).norm(), 2);
    EXPECT_NEAR(fromAxis((drawn.points()[0] + drawn.points()[1]) / 2),
                radius * std::cos(25 * std::numbers::pi / 180), 1.5)
        << "the chord goes through the frame";
}

TEST_F(FixationDrawing, BTurnsWhatIsDrawnStraightAtOnce)
{
    showFrame();
    view.setTool(CoverToolKind::DrawFixation);
    mouse.click(pixel(onTube(-50, 60)));
    mouse.click(pixel(onTube(45, 60)));
    QTest::keyClick(&view, Qt::Key_B);
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(curvesOf(document).size(), 2u);
    EXPECT_EQ(curvesOf(document).back().curve.pointCount(), 2);
}

TEST_F(FixationDrawing, AClickOnTheFirstPointCloses)
{
    showFrame();
    view.setTool(CoverToolKind::DrawFixation);
    mouse.click(pixel(onTube(-30, 40)));
    mouse.click(pixel(onTube(30, 40)));
    mouse.click(pixel(onTube(0, 160)));
    mouse.click(pixel(onTube(-30, 40)));
    ASSERT_EQ(curvesOf(document).size(), 2u);
    EXPECT_TRUE(curvesOf(document).back().curve.closed());
}

TEST_F(FixationDrawing, ADoubleClickEndsAndBackspaceTakesBack)
{
    showFrame();
    view.setTool(CoverToolKind::DrawFixation);
    mouse.click(pixel(onTube(-30, 40)));
    mouse.click(pixel(onTube(0, 160)));
    QTest::keyClick(&view, Qt::Key_Backspace);
    mouse.doubleClick(pixel(onTube(30, 40)));
    ASSERT_EQ(curvesOf(document).size(), 2u);
    const BSpline3 drawn = curvesOf(document).back().curve;
    EXPECT_LT(drawn.boundingBox().max().y(), 60) << "the second point was taken back";
}

TEST_F(FixationDrawing, PartsThatAreHiddenAreDrawnThrough)
{
    auto mesh = std::make_shared<TriangleMesh>(*tube()); // and a cushion that lies on it
    const auto count = static_cast<std::uint32_t>(mesh->triangles.size());
    const auto first = static_cast<std::uint32_t>(mesh->points.size());
    for (const Vec3& corner : {Vec3(0, 0, 200), Vec3(400, 0, 200), Vec3(400, 200, 200), Vec3(0, 200, 200)})
        mesh->points.push_back(corner);
    mesh->triangles.push_back({first, first + 1, first + 2});
    mesh->triangles.push_back({first, first + 2, first + 3});
    mesh->parts = {{"Tube", 0, count}, {"Cushion", count, 2}};
    DesignFiles files;
    files.meshes[frameId] = mesh;
    view.shown().setFiles(files);
    lookFromAbove();
    const auto under = [&] { return view.hit(pixel(onTube(10, 40))); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return under().kind == CoverHit::Kind::Frame; }));
    EXPECT_NEAR(under().position.z(), 200, 1);

    Frame frame = *document.design().find<Frame>(frameId);
    frame.hiddenParts = {"Cushion"};
    document.commit({{"Hide"}, {{frameId, document.design().element(frameId), makeElement(frame)}}});
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return under().kind == CoverHit::Kind::Frame && fromAxis(under().position) < radius + 1; }));
    view.setTool(CoverToolKind::DrawFixation);
    mouse.click(pixel(onTube(-30, 40)));
    mouse.click(pixel(onTube(30, 40)));
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(curvesOf(document).size(), 2u);
    const BSpline3 drawn = curvesOf(document).back().curve;
    EXPECT_NEAR(fromAxis(drawn.at((drawn.domainStart() + drawn.domainEnd()) / 2)), radius, 1);
    document.undo();
    document.undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return under().position.z() > 199; })) << "it is there again";
}

TEST_F(FixationDrawing, WithoutAFrameTheCoverIsTaken)
{
    view.shown().setSurface(twoSquaresCover());
    lookFromAbove();
    view.setTool(CoverToolKind::DrawFixation);
    mouse.click(pixel({50, 20, 0}));
    mouse.click(pixel({350, 40, 0}));
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(curvesOf(document).size(), 2u);
    const BSpline3 drawn = curvesOf(document).back().curve;
    EXPECT_LT(drawn.boundingBox().sizes().z(), 0.1);
    EXPECT_NEAR(drawn.at(drawn.domainEnd()).x(), 350, 2);
}

TEST_F(FixationDrawing, NothingIsLostOrMadeByAccident)
{
    view.setTool(CoverToolKind::DrawFixation);
    QSignalSpy problems(&view, &CoverView::failed);
    mouse.click({20, 20});
    EXPECT_EQ(problems.count(), 1) << "there is nothing under the pointer";
    QTest::keyClick(&view, Qt::Key_Return);
    EXPECT_EQ(problems.count(), 2) << "a curve needs two points";
    const Camera before = view.navigation().camera();
    mouse.drag({300, 300}, {360, 330});
    EXPECT_NE(view.navigation().camera(), before) << "a drag turns the view";
    EXPECT_EQ(curvesOf(document).size(), 1u);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.tool() == CoverToolKind::Select; }));
}

TEST_F(FixationDrawing, PlacesAreTyped)
{
    showFrame();
    view.setTool(CoverToolKind::DrawFixation);
    QTest::keyClick(&view, Qt::Key_B);
    for (const char* place : {"-250, -100, 40", "250, -100", "250, 300"}) {
        QTest::keyClicks(&view, QString::fromLatin1(place));
        QTest::keyClick(&view, Qt::Key_Return);
    }
    QTest::keyClicks(&view, QStringLiteral("7"));
    QTest::keyClick(&view, Qt::Key_Escape); // the number, not the curve
    QTest::keyClick(&view, Qt::Key_C);
    ASSERT_EQ(curvesOf(document).size(), 2u);
    const BSpline3 drawn = curvesOf(document).back().curve;
    EXPECT_TRUE(drawn.closed());
    EXPECT_EQ(drawn.corners().size(), 3u);
    for (const Vec3& corner : {Vec3(-250, -100, 40), Vec3(250, -100, 40), Vec3(250, 300, 40)})
        EXPECT_LT(drawn.closest(corner).distance, 1e-3);
    EXPECT_LT(drawn.closest({0, -100, 40}).distance, 1e-3) << "through the air, not along the frame";
}

TEST_F(FixationDrawing, WhereThereIsNothingTheGroundIsDrawnOn)
{
    document.reset({});
    view.setTool(CoverToolKind::DrawFixation);
    mouse.click(pixel({101, 48, 0}));
    mouse.click(pixel({299, 52, 0}));
    mouse.click(pixel({302, 149, 0}));
    QTest::keyClick(&view, Qt::Key_B);
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(curvesOf(document).size(), 1u);
    const BSpline3 drawn = curvesOf(document).back().curve;
    for (const Vec3& point : {Vec3(100, 50, 0), Vec3(300, 50, 0), Vec3(300, 150, 0)})
        EXPECT_LT(drawn.closest(point).distance, 1e-3);
}

TEST_F(FixationDrawing, EndsOfOtherCurvesAreMet)
{
    view.shown().setSurface(twoSquaresCover());
    lookFromAbove();
    view.setTool(CoverToolKind::DrawFixation);
    mouse.click(pixel({50, 20, 0}));
    mouse.click(pixel({0, 100, 50}) + QPointF(3, 2));
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(curvesOf(document).size(), 2u);
    const BSpline3 drawn = curvesOf(document).back().curve;
    EXPECT_LT((drawn.at(drawn.domainEnd()) - Vec3(0, 100, 50)).norm(), 1e-3);
}

TEST_F(FixationDrawing, PointsOnTheFrameSlideOnIt)
{
    showFrame();
    selectPointAt(onTube(0, 60));
    mouse.drag(pixel(bentPoint()), pixel(onTube(40, 80)));
    EXPECT_LT((bentPoint() - onTube(40, 80)).norm(), 1.5);
    EXPECT_NEAR(fromAxis(bentPoint()), radius, 0.1);
    document.undo();
    EXPECT_EQ(bentPoint(), onTube(0, 60)) << "one edit";
}

TEST_F(FixationDrawing, ControlLiftsOffAlongTheNormal)
{
    showFrame();
    selectPointAt(onTube(0, 60));
    const QPointF from = pixel(bentPoint()), to = pixel(onTube(0, 60) + Vec3(0, 0, 30));
    mouse.move(from);
    mouse.press(from);
    mouse.move(from + (to - from) * 0.3);
    mouse.move(from);
    mouse.move(from, Qt::ControlModifier);
    mouse.move(to, Qt::ControlModifier);
    EXPECT_LT((bentPoint() - onTube(0, 60) - Vec3(0, 0, 30)).norm(), 1.5);
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("Ctrl")));
    mouse.release(to, Qt::ControlModifier);
    EXPECT_GT(fromAxis(bentPoint()), radius + 25);
    // What does not lie on the frame moves in the plane of the picture.
    const double depth = view.navigation().camera().depth(bentPoint());
    mouse.drag(pixel(bentPoint()), pixel(bentPoint()) + QPointF(60, 0));
    EXPECT_NEAR(view.navigation().camera().depth(bentPoint()), depth, 1e-6);
}

TEST_F(FixationDrawing, AKeyLetsGoOfTheFrame)
{
    showFrame();
    selectPointAt(onTube(0, 60));
    const double depth = view.navigation().camera().depth(bentPoint());
    const QPointF from = pixel(bentPoint());
    mouse.move(from);
    mouse.press(from);
    mouse.move(from + QPointF(50, 0));
    EXPECT_NEAR(fromAxis(bentPoint()), radius, 0.1);
    QTest::keyClick(&view, Qt::Key_S);
    EXPECT_NEAR(view.navigation().camera().depth(bentPoint()), depth, 1e-6);
    EXPECT_GT(fromAxis(bentPoint()), radius + 1);
    mouse.release(from + QPointF(50, 0));
}

TEST(CoverPathTest, StraightPathsHaveCornersAtTheGivenPoints)
{
    const auto follow = [](const Vec3& p) { return std::optional(Vec3(p.x(), p.y(), 5)); };
    const std::vector<Vec3> points = {{0, 0, 5}, {100, 0, 9}, {100, 80, 5}};
    const CoverPath path = pathAlong(points, false, false, follow);
    const auto curve = curveAlong(path);
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->points(), points);
    EXPECT_TRUE(pathAlong({{1, 2, 3}, {1, 2, 3}}, false, true, follow).points.empty());
    EXPECT_FALSE(curveAlong({}));
}

class Attaching : public testing::Test {
protected:
    Attaching()
    {
        FixationCurve second{"Second", BSpline3(1, false, {{0, 300, 0}, {0, 400, 0}})};
        Patch right = *twoSquares().find<Patch>(rightPatch);
        right.position = Vec2(300, 0);
        document.reset(twoSquares().with(
            {{}, {{secondId, nullptr, makeElement(second)}, {rightPatch, nullptr, makeElement(right)}}}));
        view.resize(900, 700);
        view.show();
        view.navigation().fitAll();
        view.setTool(PatternToolKind::Attach);
    }

    QPointF pixel(const Vec2& layout) const { return view.navigation().transform().toPixels(layout); }
    std::vector<FixationSeam> seams() const
    {
        std::vector<FixationSeam> result;
        document.design().each<FixationSeam>([&](ElementId, const FixationSeam& s) { result.push_back(s); });
        return result;
    }

    const ElementId secondId{41};
    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
    Mouse mouse{view};
};

TEST_F(Attaching, AClickFixesAnEdgeToTheSelectedCurve)
{
    selection.set({curveId});
    mouse.click(pixel({100, 0}));
    ASSERT_EQ(seams().size(), 1u);
    EXPECT_EQ(seams()[0].curve, curveId);
    EXPECT_EQ(seams()[0].stretch.from, 0);
    EXPECT_EQ(seams()[0].stretch.to, 1);
    EXPECT_EQ(selection.elements(), Selection::Elements{curveId});
}

TEST_F(Attaching, GoesOnUntilEscape)
{
    selection.set({curveId});
    mouse.click(pixel({100, 0}));
    QCoreApplication::processEvents();
    ASSERT_EQ(view.tool(), PatternToolKind::Attach);
    mouse.click(pixel({0, 100}));
    ASSERT_EQ(seams().size(), 2u) << "another edge of the same curve";
    selection.set({secondId});
    mouse.click(pixel({400, 0}));
    ASSERT_EQ(seams().size(), 3u);
    EXPECT_EQ(seams()[2].curve, secondId);
    EXPECT_EQ(document.history().count(), 4) << "one edit each";
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.tool() == PatternToolKind::Select; }));
}

TEST_F(Attaching, ShiftCollectsStretchesThatShareTheCurve)
{
    selection.set({curveId});
    mouse.click(pixel({100, 0}), Qt::ShiftModifier);
    EXPECT_TRUE(seams().empty());
    mouse.click(pixel({0, 100}), Qt::ShiftModifier);
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(seams().size(), 2u);
    EXPECT_TRUE(seams()[0].curveRange && seams()[1].curveRange);
    EXPECT_EQ(document.history().count(), 2) << "one edit";
}

TEST_F(Attaching, OneStretchIsDividedAmongSelectedCurves)
{
    selection.set({curveId, secondId});
    mouse.click(pixel({100, 0}));
    ASSERT_EQ(seams().size(), 2u);
    EXPECT_NE(seams()[0].curve, seams()[1].curve);
}

TEST_F(Attaching, SaysWhyNot)
{
    QSignalSpy failures(&view, &PatternView::failed);
    mouse.click(pixel({100, 0}));
    ASSERT_EQ(failures.count(), 1) << "no curve is selected";
    selection.set({curveId});
    mouse.click(pixel({100, 100}));
    ASSERT_EQ(failures.count(), 2) << "inside the patch";
    FixationSeam half;
    half.stretch = {leftPatch, 0, 0.5};
    half.curve = secondId;
    document.commit({{"Fix", {}}, {{ElementId{50}, nullptr, makeElement(half)}}});
    mouse.click(pixel({150, 0}));
    ASSERT_EQ(failures.count(), 3) << "a part of the edge is fixed already";
    EXPECT_EQ(seams().size(), 1u);
}

TEST_F(Attaching, TheStretchThroughSelectedPointsIsMeant)
{
    const Design& design = document.design();
    selection.set({leftPatch}, {{leftPatch, 0}, {leftPatch, 1}});
    EXPECT_EQ(stretchToFix(design, selection), (Stretch{leftPatch, 0, 1}));
    selection.set({leftPatch}, {{leftPatch, 0}, {leftPatch, 2}, {leftPatch, 3}});
    EXPECT_EQ(stretchToFix(design, selection), (Stretch{leftPatch, 2, 0}));
    selection.set({leftPatch}, {{leftPatch, 0}});
    EXPECT_FALSE(stretchToFix(design, selection));
    selection.set({seamId});
    EXPECT_EQ(stretchToFix(design, selection), design.find<Seam>(seamId)->a);
    EXPECT_EQ(outlineEdgeAt(leftPatch, design.find<Patch>(leftPatch)->outline, 3.5), (Stretch{leftPatch, 3, 0}));
}

} // namespace
} // namespace bolster::test
